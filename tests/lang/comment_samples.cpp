// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/lang/comment_samples.h"

#include <array>
#include <string_view>

#include "lang/text/russian_pairs.h"
#include "lang/text/utf8.h"

namespace dgt::support {
namespace {

constexpr std::array<std::string_view, 24> kSubjects = {"крышка редуктора",
                                                        "шестерня привода",
                                                        "копирный вал",
                                                        "нож дробилки",
                                                        "деталь по эскизу",
                                                        "звёздочка цепная",
                                                        "нижний штамп",
                                                        "прокладка насоса",
                                                        "кронштейн датчика",
                                                        "вырубная вставка",
                                                        "рейка зубчатая",
                                                        "опытный образец",
                                                        "съёмная губка тисков",
                                                        "мелкая серия",
                                                        "ключ гаечный",
                                                        "фильера",
                                                        "щека правая",
                                                        "ротор пробный",
                                                        "гребёнка",
                                                        "юстировочный клин",
                                                        "заглушка бака",
                                                        "этажерка под инструмент",
                                                        "цанга с тремя лепестками",
                                                        "хомут для шланга"};
constexpr std::array<std::string_view, 24> kActions = {"режем с запасом",
                                                       "делать аккуратно",
                                                       "взять из остатков",
                                                       "выполнять после калибровки",
                                                       "сверить с эталоном",
                                                       "подрезать изнутри",
                                                       "пропустить первый угол",
                                                       "обойти слева",
                                                       "греть нельзя",
                                                       "включить подсветку",
                                                       "сделать шесть копий",
                                                       "доводка вручную",
                                                       "убрать заусенцы",
                                                       "сменить направляющие",
                                                       "замерить ещё раз",
                                                       "ждать наладчика",
                                                       "увеличить напряжение",
                                                       "отложить до понедельника",
                                                       "не трогать опоры",
                                                       "резать с другого конца",
                                                       "двигаться мелким шагом",
                                                       "вычесть диаметр нити",
                                                       "разбить на две половины",
                                                       "записать в журнал"};
constexpr std::array<std::string_view, 12> kRemarks = {
    "см. лист 2", "R5 везде",        "2 шт",      "№ 14",      "сталь 45", "t=8 мм",
    "проба",      "вариант 3, итог", "для Петра", "ГОСТ 1050", "цех 7",    "к заказу 112"};
constexpr std::array<std::string_view, 6> kCode = {
    "L1=X0 Y0 A30", "C2=X14 Y0 R-5", "K1 W0.1 P1 L1 C2 L2,", "N1=N1-60", "FOR 5", "P3=L1 C2"};

std::string capitals(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const CodePoint c = code_point_at(text, i);
    char32_t capital = c.value;
    if (capital >= U'а' && capital <= U'я') capital -= U'а' - U'А';
    if (capital == U'ё') capital = U'Ё';
    append_utf8(out, capital);
    i += c.size;
  }
  return out;
}

std::size_t count_letters(std::string_view text) {
  std::size_t letters = 0;
  for (std::size_t i = 0; i < text.size();) {
    const CodePoint c = code_point_at(text, i);
    if (russian_letter(c.value)) ++letters;
    i += c.size;
  }
  return letters;
}

}  // namespace

// Taken from the engine by hand: distributions differ between standard libraries.
std::uint32_t CommentSamples::below(std::uint32_t bound) {
  return static_cast<std::uint32_t>(random_()) % bound;
}

std::string CommentSamples::next(std::size_t letters, Writing writing) {
  std::string text;
  while (count_letters(text) < letters) {
    if (!text.empty()) text += below(2) == 0 ? ", " : " ";
    text += kSubjects.at(below(kSubjects.size()));
    text += below(3) == 0 ? ": " : " ";
    text += kActions.at(below(kActions.size()));
    if (below(3) == 0) text.append(" ").append(kRemarks.at(below(kRemarks.size())));
  }
  if (writing == Writing::Capitals) return capitals(text);
  const std::size_t first = code_point_at(text, 0).size;
  return writing == Writing::Small ? text : capitals(text.substr(0, first)) + text.substr(first);
}

std::string CommentSamples::program(std::size_t letters) {
  std::string text;
  for (std::uint32_t line = 0; line < 8; ++line) {
    text += kCode.at(below(kCode.size()));
    if (line % 3 == 1) text += " ' " + next(letters, static_cast<Writing>(below(3)));
    text += "\r\n";
  }
  return text;
}

}  // namespace dgt::support
