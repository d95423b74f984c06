// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/program_generators.h"

#include <algorithm>
#include <array>
#include <random>
#include <string_view>

#include "lang/dgt/forms.h"

namespace dgt::support {
namespace {

using Kind = PieceKind;

/// `[0, count)`.
int below(int count) { return *rc::gen::inRange(0, count); }
bool one_in(int count) { return below(count) == 0; }

template <std::size_t N>
std::string one_of(const std::array<std::string_view, N>& texts) {
  return std::string(texts.at(static_cast<std::size_t>(below(static_cast<int>(N)))));
}

// --- lines, from a plain notation ---------------------------------------------------------------

bool is_digit(char c) { return (c >= '0' && c <= '9') || c == '.'; }

/// `L1=X10` and the like without blanks inside words; a blank stands for a separator.
std::vector<Piece> pieces_of(std::string_view plain) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < plain.size();) {
    const char c = plain[i];
    std::size_t size = 1;
    if (is_digit(c)) {
      while (i + size < plain.size() && is_digit(plain[i + size])) ++size;
      const bool begins_value =
          !pieces.empty() && pieces.back().text != "N" &&
          (pieces.back().kind == Kind::Letter || pieces.back().kind == Kind::Mark);
      if (begins_value) pieces.push_back({Kind::Plus, ""});
      pieces.push_back({Kind::Number, std::string(plain.substr(i, size))});
    } else if (c == ' ') {
      pieces.push_back({Kind::Separator, ""});
    } else if (c == '-') {
      pieces.push_back({Kind::Minus, "-"});
    } else if (c >= 'A' && c <= 'Z') {
      pieces.push_back({Kind::Letter, std::string(1, c)});
    } else {
      pieces.push_back({c == '"' ? Kind::Quote : Kind::Mark, std::string(1, c)});
    }
    i += size;
  }
  return pieces;
}

SkeletonLine line(std::string_view plain) { return {pieces_of(plain), false, "", false}; }
SkeletonLine keyword(std::string_view word, std::string_view value) {
  SkeletonLine result;
  result.pieces = {{Kind::Keyword, std::string(word)}};
  for (Piece& piece : pieces_of(value)) {
    if (piece.kind != Kind::Separator) result.pieces.push_back(std::move(piece));
  }
  return result;
}
SkeletonLine going_on(std::string_view plain) {
  SkeletonLine result = line(plain);
  result.pieces.push_back({Kind::Separator, ""});
  result.goes_on = true;
  return result;
}
SkeletonLine macro_call(std::string_view arguments) {
  SkeletonLine result = keyword("MAC", "");
  result.pieces.push_back({Kind::Name, "SLOT"});
  for (Piece& piece : pieces_of(arguments)) result.pieces.push_back(std::move(piece));
  return result;
}

// --- numbers and items --------------------------------------------------------------------------

std::string any_number() {
  static constexpr std::array<std::string_view, 10> kNumbers = {
      "0", "1", "2", "5", "10", "0.5", "12.25", "0.001", "40", "1234567890123456789.25"};
  return one_of(kNumbers);
}
std::string any_value() {
  const std::string sign = one_in(4) ? "-" : "";
  if (one_in(4)) return sign + "N" + std::to_string(1 + below(30));
  return sign + any_number();
}
std::string any_index() { return one_in(5) ? "N1" : std::to_string(below(6)); }

std::string any_item(char letter) {
  switch (letter) {
    case 'P':
      return one_in(2) ? "P" + any_index() : "X" + any_value() + " Y" + any_value();
    case 'L':
    case 'C':
      return letter + std::string(one_in(3) ? "-" : "") + any_index();
    case 'O':
      return "O" + any_index();
    case 'V':
      return one_in(2) ? "V" : "V" + any_number();
    case 'I':
      return one_in(3) ? std::string(one_in(2) ? "X>" : "Y<") : "I" + std::to_string(1 + below(6));
    default:
      return letter + any_value();
  }
}

// --- stretches of programs ----------------------------------------------------------------------

void add_definition(Skeleton& out) {
  const auto forms = language::all_forms();
  const auto& form = forms[static_cast<std::size_t>(below(static_cast<int>(forms.size())))];
  std::string plain = static_cast<char>(form.result) + any_index() + "=";
  if (form.takes_selector && one_in(2)) plain += any_item('I') + " ";
  for (std::size_t i = 0; i < form.operands.size(); ++i) {
    if (i > 0) plain += " ";
    plain += any_item(form.operands[i]);
  }
  out.push_back(line(plain));
}

std::string any_items() {
  static constexpr std::string_view kLetters = "LLLCCCPXYRVDZAOWUFSTMI";
  std::string plain;
  for (int count = 1 + below(6); count > 0; --count) {
    if (!plain.empty()) plain += " ";
    plain += any_item(kLetters[static_cast<std::size_t>(below(static_cast<int>(kLetters.size())))]);
  }
  return plain;
}

void add_contour(Skeleton& out) {
  out.push_back(line("K" + std::to_string(below(9)) + " " + any_items()));
  for (int count = below(3); count > 0; --count) out.push_back(going_on(any_items()));
}

/// A rectangle from the axes to N1, N2, entered from below; it compiles.
void add_rectangle(Skeleton& out) {
  const std::string corner = one_of<4>({"", "R2 ", "V2 ", "R0.125 "});
  const bool as_text = one_in(3);
  out.push_back(line("N1=" + std::to_string(20 + below(50)) + "+5*2/4"));
  out.push_back(line("N2=" + std::to_string(20 + below(50)) + ".25-N1*0+-1"));
  for (const char* plain : {"L1=Y0", "L2=XN1", "L3=YN2", "L4=X0", "P1=X10 Y-5", "G54 X10 Y-5"}) {
    out.push_back(line(plain));
  }
  const std::string second = "L-3 " + corner + "L4 L1 P1";
  if (as_text) out.push_back(line("B3=\"" + second + ",\""));
  out.push_back(line("K1 W0." + std::to_string(below(10)) + "5 P1 L1 " + corner + "L-2 " +
                     (corner.empty() ? "" : corner.substr(0, corner.size() - 1))));
  if (out.back().pieces.back().kind == Kind::Separator) out.back().pieces.pop_back();
  if (as_text) {
    out.push_back(line("B3"));
  } else {
    out.push_back(going_on(second));
  }
  out.push_back(line("G0 X10 Y-5"));
}

void add_loop(Skeleton& out, int depth);

void add_stretch(Skeleton& out, int depth) {
  switch (below(7)) {
    case 0:
      return add_contour(out);
    case 1:
      return add_rectangle(out);
    case 2:
      return out.push_back(macro_call("30,6,0.2,-N4,15,"));
    case 3:
      return out.push_back(line("N" + std::to_string(1 + below(30)) + "=" + any_value() +
                                one_of<4>({"+", "-", "*", "/"}) + any_value()));
    case 4:
      return add_loop(out, depth);
    default:
      return add_definition(out);
  }
}

void add_loop(Skeleton& out, int depth) {
  out.push_back(keyword("FOR", std::to_string(below(4))));
  for (int count = depth < 3 ? below(3) : 0; count > 0; --count) add_stretch(out, depth + 1);
  out.push_back(keyword("NEXT", ""));
}

void add_comments(Skeleton& program) {
  static constexpr std::array<std::string_view, 5> kComments = {
      "' comment", "'С2  р4,  L 1", "''@", "'@ offset-side left", "' \"quoted\" , text"};
  for (SkeletonLine& one : program) {
    if (one_in(3)) one.comment = one_of(kComments);
    one.blank_before = one_in(5);
  }
  if (one_in(3))
    program.insert(program.begin() + below(static_cast<int>(program.size()) + 1),
                   {{}, false, one_of(kComments), false});
}

// --- spelling -----------------------------------------------------------------------------------

class Speller {
 public:
  explicit Speller(unsigned seed) : plain_(seed == 0), random_(seed) {}

  std::string spell(const Skeleton& skeleton) {
    const std::string end = pick({"\n", "\r\n", "\r", "\n"});
    std::string out;
    for (const SkeletonLine& one : skeleton) {
      if (one.blank_before) out += pick({"", "\t", " "}) + end;
      if (one.blank_before && chance(3)) out += end;
      append(out, one);
      out += end;
    }
    return out;
  }

 private:
  bool chance(unsigned one_in) { return !plain_ && random_() % one_in == 0; }
  /// The first when plain.
  std::string pick(std::initializer_list<std::string_view> texts) {
    return std::string(texts.begin()[plain_ ? 0 : random_() % texts.size()]);
  }
  std::string blanks() {
    return chance(2) ? pick({" ", " ", "  ", "\t", "\u00A0"}) : std::string();
  }

  static bool is_contour_start(const SkeletonLine& one) {
    return !one.pieces.empty() && one.pieces.front().text == "K";
  }
  static bool is_definition(const SkeletonLine& one) {
    return one.pieces.size() > 2 &&
           std::string_view("LCPO").find(one.pieces.front().text) != std::string_view::npos &&
           std::ranges::count(one.pieces, "=", &Piece::text) > 0;
  }

  void append(std::string& out, const SkeletonLine& one) {
    bool needs_comma = one.goes_on;
    // Elsewhere a comma means something: in texts, and in lines like `G0 X5 Y7`.
    const bool may_have_commas = one.goes_on || is_contour_start(one) || is_definition(one);
    out += blanks();
    for (std::size_t i = 0; i < one.pieces.size(); ++i) {
      const Piece& piece = one.pieces[i];
      if (piece.kind == Kind::Separator) {
        const bool last = i + 1 == one.pieces.size();
        const bool comma = (may_have_commas && chance(3)) || (last && needs_comma);
        if (comma) needs_comma = false;
        out += comma ? "," : plain_ ? " " : "";
      } else {
        append(out, piece);
      }
      const bool is_name = piece.kind == Kind::Name;
      out += is_name && i + 1 < one.pieces.size() ? pick({" ", "\t "}) : blanks();
    }
    out += one.comment;
    if (!one.comment.empty() && chance(3)) out += "  ";
  }

  void append(std::string& out, const Piece& piece) {
    switch (piece.kind) {
      case Kind::Letter:
      case Kind::Keyword:
        for (const char c : piece.text) out += letter(c);
        return;
      case Kind::Number:
        out += number(piece.text);
        return;
      case Kind::Plus:
        if (chance(5)) out += "+" + blanks();
        return;
      case Kind::Minus:
        out += pick({"-", "-", "-", "\u2212"});
        return;
      default:
        out += piece.text;
    }
  }

  std::string letter(char c) {
    static constexpr std::string_view kLatin = "ABCEKMOPTXY";
    static constexpr std::array<std::string_view, 11> kCyrillic = {"А", "В", "С", "Е", "К", "М",
                                                                   "О", "Р", "Т", "Х", "у"};
    const std::size_t twin = kLatin.find(c);
    if (twin != std::string_view::npos && chance(8)) return std::string(kCyrillic.at(twin));
    return std::string(1, chance(4) ? static_cast<char>(c - 'A' + 'a') : c);
  }

  std::string number(std::string text) {
    const bool has_point = text.find('.') != std::string::npos;
    if (chance(8)) return "0" + text;
    if (text.starts_with("0.") && chance(2)) return text.substr(1);
    if (chance(4)) return text + (has_point ? "00" : ".");
    return text;
  }

  bool plain_;
  std::mt19937 random_;
};

}  // namespace

const std::string kMacro =
    "L91=Y N2\nL92=Y-1\nP91=XN1 YN3\nC91=P91 RN2\nG54 XN1 YN4\nK91 WN3 P91 L91 L92\n";

rc::Gen<Skeleton> any_skeleton() {
  return rc::gen::exec([] {
    Skeleton program;
    for (int count = 1 + below(6); count > 0; --count) add_stretch(program, 0);
    add_comments(program);
    return program;
  });
}

std::string spelling(const Skeleton& skeleton, unsigned seed) {
  return Speller(seed).spell(skeleton);
}

rc::Gen<std::string> any_spelling(const Skeleton& skeleton) {
  return rc::gen::map(rc::gen::arbitrary<unsigned>(),
                      [skeleton](unsigned seed) { return spelling(skeleton, seed); });
}

rc::Gen<std::string> any_program() {
  return rc::gen::mapcat(any_skeleton(), [](const Skeleton& s) { return any_spelling(s); });
}

}  // namespace dgt::support
