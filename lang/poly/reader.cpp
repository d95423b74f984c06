// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/poly/reader.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "lang/text/reading.h"

namespace dgt {
namespace {

constexpr std::string_view kBlanks = " \t\v\f";
constexpr std::size_t kNumbersOfVertex = 3;

/// The first words of a line; what stands behind them is kept in one piece.
struct Words {
  std::array<Range, kNumbersOfVertex> first;
  std::size_t count = 0;  ///< of `first`
  std::optional<Range> surplus;
};

class PolyReader {
 public:
  PolyReader(const SourceFile& file, DiagnosticBag& bag) : file_(file), bag_(bag) {}

  std::vector<PolyLoop> run() {
    for (std::uint32_t line = 1; line <= file_.line_count(); ++line) read_line(line);
    end_loop();
    if (open_) report(Message::PolyMisplacedOpen, *open_);  // nothing follows it
    return std::move(loops_);
  }

 private:
  void report(Message message, const Range& range, std::vector<std::string> arguments = {}) {
    bag_.add({message, range, std::move(arguments)});
    is_faulty_ = true;
  }

  void read_line(std::uint32_t line) {
    std::string_view text = file_.line_text(line);
    const std::size_t comment = text.find('#');
    text = text.substr(0, comment);
    const Words words = words_of(text, file_.line_start(line));
    if (words.count == 0) {
      if (comment == std::string_view::npos) end_loop();
    } else if (words.first.front().text() == "open") {
      read_open(words);
    } else {
      read_vertex(words);
    }
  }

  [[nodiscard]] Words words_of(std::string_view text, std::uint32_t start) const {
    const auto range = [&](std::size_t begin, std::size_t end) {
      return Range{&file_, start + static_cast<std::uint32_t>(begin),
                   start + static_cast<std::uint32_t>(end)};
    };
    Words words;
    std::size_t at = text.find_first_not_of(kBlanks);
    while (at != std::string_view::npos) {
      if (words.count == kNumbersOfVertex) {
        words.surplus = range(at, text.find_last_not_of(kBlanks) + 1);
        break;
      }
      const std::size_t end = std::min(text.find_first_of(kBlanks, at), text.size());
      words.first.at(words.count++) = range(at, end);
      at = text.find_first_not_of(kBlanks, end);
    }
    return words;
  }

  void read_open(const Words& words) {
    const bool alone = words.count == 1;
    if (!alone || open_ || !places_.empty()) {
      report(Message::PolyMisplacedOpen, words.first.front());
    } else {
      open_ = words.first.front();
    }
  }

  void read_vertex(const Words& words) {
    std::array<Rational, kNumbersOfVertex> numbers;
    for (std::size_t i = 0; i < words.count; ++i) {
      numbers.at(i) = number(words.first.at(i));
    }
    if (words.count < kNumbersOfVertex) {
      report(Message::PolyMissingNumbers, behind(words.first.at(words.count - 1)),
             {std::to_string(words.count)});
    }
    if (words.surplus) {
      report(Message::ExtraWords, *words.surplus, {std::string(words.surplus->text())});
    }
    auto& [x, y, bulge] = numbers;
    vertices_.push_back({{std::move(x), std::move(y)}, std::move(bulge)});
    places_.push_back(join(words.first.front(), words.first.at(words.count - 1)));
  }

  Rational number(const Range& range) {
    const std::string_view text = range.text();
    const auto digits = std::ranges::count_if(text, [](char c) { return c >= '0' && c <= '9'; });
    if (digits > kMaxPolyDigits) {
      report(Message::NumberTooLong, range,
             {std::to_string(digits), std::to_string(kMaxPolyDigits)});
      return 0;
    }
    auto value = parse_scientific(text);
    if (!value) report(Message::PolyNotANumber, range, {std::string(text)});
    return value ? *std::move(value) : Rational();
  }

  void end_loop() {
    if (places_.empty()) return;  // blank lines in a row
    if (!is_faulty_) {
      if (auto chain = chain_of(vertices_, !open_)) {
        std::vector<Range> places = places_of(*chain);
        loops_.push_back({*std::move(chain), std::move(places)});
      } else {
        report(Message::PolyTooFewVertices, places_.front());
      }
    }
    vertices_.clear();
    places_.clear();
    open_.reset();
    is_faulty_ = false;
  }

  /// Vertices that coincide with the one before begin no edge, great arcs are two.
  [[nodiscard]] std::vector<Range> places_of(const Chain& chain) const {
    std::vector<Range> places;
    places.reserve(chain.edges.size());
    std::size_t at = 0;
    std::size_t next = next_distinct(at);
    for (const ChainEdge& edge : chain.edges) {
      if (next < vertices_.size() && edge.from == vertices_[next].at) {
        at = next;
        next = next_distinct(at);
      }
      places.push_back(places_[at]);
    }
    return places;
  }
  [[nodiscard]] std::size_t next_distinct(std::size_t at) const {
    std::size_t next = at + 1;
    while (next < vertices_.size() && vertices_[next].at == vertices_[at].at) ++next;
    return next;
  }

  const SourceFile& file_;
  DiagnosticBag& bag_;
  std::vector<PolyLoop> loops_;
  // The loop that is being read.
  std::vector<BulgeVertex> vertices_;
  std::vector<Range> places_;
  std::optional<Range> open_;
  bool is_faulty_ = false;
};

}  // namespace

std::vector<PolyLoop> read_poly(const SourceFile& file, DiagnosticBag& bag) {
  report_reading(file, bag);
  return PolyReader(file, bag).run();
}

}  // namespace dgt
