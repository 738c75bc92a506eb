// The kernels against crossings that were found without any of their formulas
// (oracle/make_goldens.py).
#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

#include "hard/kernels/zoo.h"

namespace alhazen::hard {
namespace {

struct Golden {
  std::string kind;
  std::vector<double> numbers, ray, t;

  Vec3d vector(std::size_t at) const { return {numbers[at], numbers[at + 1], numbers[at + 2]}; }
  Geometry geometry() const {
    if (kind == "sphere") return alhazen::Sphere{vector(0), numbers[3]};
    if (kind == "box") return alhazen::Box{vector(0), vector(3)};
    if (kind == "cylinder") return Cylinder{vector(0), vector(3), numbers[6], true};
    if (kind == "cone") return Cone{vector(0), vector(3), numbers[6], numbers[7], true};
    if (kind == "plane") return alhazen::Plane{vector(0), numbers[3]};
    if (kind == "disc") return alhazen::Disc{vector(0), vector(3), numbers[6], numbers[7]};
    if (kind == "triangle") return alhazen::Triangle{{vector(0), vector(3), vector(6)}, {}};
    return Quad4{vector(0), vector(3), vector(6)};
  }
  // The largest coordinate or length that places shape and origin.
  double extent() const {
    double largest = 0;
    for (const auto* list : {&numbers, &ray}) {
      for (const double x : *list)
        largest = larger(largest, std::abs(x));
    }
    return largest;
  }
  bool fits(float) const {
    for (const auto* list : {&numbers, &ray}) {
      for (const double x : *list) {
        if (static_cast<double>(static_cast<float>(x)) != x) return false;
      }
    }
    return true;
  }
  bool fits(double) const { return true; }
};

std::vector<Golden> goldens() {
  std::ifstream file(ALHAZEN_SOURCE_DIR "/tests/hard/oracle/goldens.txt");
  std::vector<Golden> all;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    Golden golden;
    words >> golden.kind;
    std::vector<double>* lists[] = {&golden.numbers, &golden.ray, &golden.t};
    std::size_t list = 0;
    for (std::string word; words >> word;) {
      if (word == ":") {
        ++list;
      } else {
        lists[list]->push_back(std::strtod(word.c_str(), nullptr));
      }
    }
    all.push_back(golden);
  }
  return all;
}

struct Agreement {
  double miscounted = 0, worst = 0, worst_conditioned = 0;
  std::size_t rays = 0;
};

template <class Real>
void compare(const Golden& golden, Agreement& agreement) {
  const ShapeTable<Real> table({shape_of(golden.geometry())}, Vec3d{});
  const Ray<Real> ray = ray_of<Real>({golden.ray[0], golden.ray[1], golden.ray[2]},
                                     {golden.ray[3], golden.ray[4], golden.ray[5]});
  const auto hits = table.crossings(0, ray, Departure());
  ++agreement.rays;
  if (hits.size() != static_cast<int>(golden.t.size())) {
    ++agreement.miscounted;
    return;
  }
  for (int i = 0; i < hits.size(); ++i) {
    const double t = golden.t[static_cast<std::size_t>(i)];
    const double error = std::abs(static_cast<double>(hits[i].t) - t) / t / kEps<Real>;
    const Vec3d n(table.plain_surface(0, ray, hits[i]).normal), d(ray.direction);
    const double kappa = condition(n, d, t, golden.extent());
    agreement.worst = larger(agreement.worst, error);
    agreement.worst_conditioned = larger(agreement.worst_conditioned, error / kappa);
  }
}

// Frames, and origins seen from centres, are rounded before the kernel begins, so the bound is on
// the error over its condition: 4 eps, as in A1, and the golden's own half.
template <class Real>
void report(const std::string& wanted) {
  Agreement agreement;
  for (const Golden& golden : goldens()) {
    if (golden.kind == wanted && golden.fits(Real())) compare<Real>(golden, agreement);
  }
  EXPECT_GE(agreement.rays, 30u) << wanted;
  const std::string id = "Oracle_" + wanted;
  figure_in<Real>(id, wanted + ": wrong counts", agreement.miscounted, 0);
  figure_in<Real>(id, wanted + ": error of t over its condition", agreement.worst_conditioned, 4.5,
                  "eps");
  std::cout << "  " << wanted << ": largest relative error " << agreement.worst << " eps in "
            << agreement.rays << " rays\n";
}

void in_both(const std::string& wanted) {
  report<double>(wanted);
  report<float>(wanted);
}

TEST(Hard, Oracle_Sphere) {
  in_both("sphere");
}
TEST(Hard, Oracle_Box) {
  in_both("box");
}
TEST(Hard, Oracle_Cylinder) {
  in_both("cylinder");
}
TEST(Hard, Oracle_Cone) {
  in_both("cone");
}
TEST(Hard, Oracle_Plane) {
  in_both("plane");
}
TEST(Hard, Oracle_Disc) {
  in_both("disc");
}
TEST(Hard, Oracle_Triangle) {
  in_both("triangle");
}
TEST(Hard, Oracle_Quad) {
  in_both("quad");
}

}  // namespace
}  // namespace alhazen::hard
