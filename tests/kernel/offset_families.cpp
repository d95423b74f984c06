// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kernel/offset_families.h"

#include <cmath>
#include <numbers>
#include <random>

namespace dgt::families {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// Decimals of a drawing: whole ten-thousandths.
Rational decimal(double value) {
  Rational r(static_cast<long>(std::lround(value * 10000)), 10000L);
  r.canonicalize();
  return r;
}

/// Uniform in [low, high), from the engine's own bits: library distributions differ between
/// machines.
double uniform(std::mt19937& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
}

BulgeVertex polar(double radius, double angle, double bulge = 0) {
  return {{decimal(radius * std::cos(angle)), decimal(radius * std::sin(angle))}, decimal(bulge)};
}

}  // namespace

std::vector<Chain> random_ring(unsigned n, unsigned seed) {
  std::mt19937 random(seed);
  const double radius = n / kTurn;
  std::vector<BulgeVertex> vertices;
  for (unsigned i = 0; i < n; ++i) {
    const double angle = kTurn * i / n;
    const double r = radius * (1 + 0.1 * std::sin(5 * angle)) + uniform(random, -0.4, 0.4);
    const double bulge = random() % 2 == 0 ? uniform(random, -0.25, 0.25) : 0;
    vertices.push_back(polar(r, angle, bulge));
  }
  return {chain_of(vertices, true).value()};
}

std::vector<Chain> slots(unsigned k) {
  const double outer = 4.0 * k / kTurn + 8;
  const double inner = outer - 8;
  std::vector<BulgeVertex> vertices;
  for (unsigned i = 0; i < k; ++i) {
    const double angle = kTurn * i / k;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const auto at = [&](double along, double across, double bulge) {
      return BulgeVertex{{decimal(along * c - across * s), decimal(along * s + across * c)},
                         decimal(bulge)};
    };
    vertices.push_back(at(outer, -1, 0));
    vertices.push_back(at(inner, -1, -1));
    vertices.push_back(at(inner, 1, 0));
    vertices.push_back(at(outer, 1, 0));
  }
  return {chain_of(vertices, true).value()};
}

std::vector<Chain> grid_pocket(unsigned cells, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<BulgeVertex> vertices;
  // A comb: teeth of whole-number heights on a whole-number pitch, closed by a straight back.
  long x = 0;
  for (unsigned i = 0; i < cells; ++i) {
    const long height = 2 + static_cast<long>(random() % 7);
    const long width = 1 + static_cast<long>(random() % 3);
    vertices.push_back({{Rational(x), Rational(height)}, 0});
    vertices.push_back({{Rational(x + width), Rational(height)}, 0});
    x += width;
  }
  vertices.push_back({{Rational(x), Rational(-4)}, 0});
  vertices.push_back({{Rational(0), Rational(-4)}, 0});
  return {reversed(chain_of(vertices, true).value())};
}

std::vector<Chain> wavy(unsigned n) {
  const double radius = n * 0.1 / kTurn;
  std::vector<BulgeVertex> vertices;
  for (unsigned i = 0; i < n; ++i) {
    const double angle = kTurn * i / n;
    vertices.push_back(polar(radius + 2 * std::sin(12 * angle), angle));
  }
  return {chain_of(vertices, true).value()};
}

}  // namespace dgt::families
