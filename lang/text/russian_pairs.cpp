// SPDX-License-Identifier: GPL-3.0-or-later
#include "lang/text/russian_pairs.h"

#include <array>
#include <string_view>

namespace dgt {
namespace {

// Row: a letter, а to я, then the boundary; column: what follows it, in the same order; a
// hexadecimal digit of bits. Counted over our own tests/lang/data/shop_notes.txt as
//   -log2((n(pair) + w (n(next) + 1) / (n + 33)) / (n(letter) + w)),   w = 4,
// so that a pair not seen is as likely as its second letter makes it. A test counts again.
constexpr std::array<std::string_view, kRussianLetters + 1> kBits = {
    "a5564575a66444a5543cf7e58ffccf852",  // а
    "5a8a94b94a5495282874c4bab5555cca5",  // б
    "4c7c73c74c4574375655e7dbcef3bedb3",  // в
    "4a8a95b94a8384282879cbb9bcd99cc93",  // г
    "3b3ca37b3b74a53779947c5bcd75bedb3",  // д
    "ad6d5755866543a83438f67666fccfec3",  // е
    "4a8a43a9298882687775cab9abd99cb94",  // ж
    "1b6b66ba8b6545498983db55bde6adc53",  // з
    "6767746465545397543688568efccf882",  // и
    "7a8a58ba8a9558798859cbbabcdaacca0",  // й
    "2c7ca6cb3ca4a62a3a54ecdbcefbbedb3",  // к
    "3caca3772c65a63a9796ecdbc6fb3e554",  // л
    "3caca2cb4b6a57479996ecdbcdf45ed62",  // м
    "2cbd73dc3c7bb43ba644fde8def47fe64",  // н
    "a435376c74444476444c86e57ffdc8fd3",  // о
    "4caca4cb5c74a92a2a94ecdbcefbbed56",  // п
    "2c8d63dc3c68b528a75586ec8ef5cfe54",  // р
    "575c55db5c4464356727e7d6de8c6ee43",  // с
    "3d5db4dc4d5bb63b34a4fde8df853fe84",  // т
    "6574694b9b644684434ae7d5cdebbe472",  // у
    "28687698287376276667a9989ab88aa84",  // ф
    "5a8a87a9598883184778cab9abd99cb94",  // х
    "297982a8497776676764baa8abc38bb83",  // ц
    "2b9b92ba2a3994898856dbcabdeaadca7",  // ч
    "498a82a9294484457758cab9abd99cb94",  // ш
    "38797198387776576663b9a89ab88ba85",  // щ
    "58686187576665565556a8978ab77a974",  // ъ
    "864b94b6835948863589d5c55deaadca2",  // ы
    "8b9b66b68b5994698669dbca5deaadca0",  // ь
    "58687698683276576617a9989ab88aa84",  // э
    "69797698687776676367b9a294c88ba81",  // ю
    "8b96586a8a9948796839dbcabceaadc51",  // я
    "863747e44e4654435355778568fdd6fda",  // _
};

}  // namespace

std::optional<RussianLetter> russian_letter(char32_t value) {
  constexpr std::uint32_t kYe = U'е' - U'а';
  if (value >= U'а' && value <= U'я') return RussianLetter{value - U'а', false};
  if (value >= U'А' && value <= U'Я') return RussianLetter{value - U'А', true};
  if (value == U'ё') return RussianLetter{kYe, false};
  if (value == U'Ё') return RussianLetter{kYe, true};
  return std::nullopt;
}

std::uint32_t surprise(std::uint32_t letter, std::uint32_t next) {
  const char digit = kBits.at(letter).at(next);
  return static_cast<std::uint32_t>(digit >= 'a' ? digit - 'a' + 10 : digit - '0');
}

}  // namespace dgt
