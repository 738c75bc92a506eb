// render/film: pixels by what one more sample of them gains, in classes, so
// that what a choice among them leads to is known from a few sums.
#pragma once

#include <cstdint>
#include <vector>

namespace alhazen::render {

class PriorityClasses {
 public:
  // The class of a pixel: higher for a greater `priority`, 0 for one that gains nothing.
  static int of(double priority);

  PriorityClasses();
  // A pixel of class `k` with so many samples, whose variance costs `loss`.
  void add(int k, double loss, double samples);

  double loss() const;
  // The highest class such that the loss falls to `goal` when what is above is doubled until all
  // gain equally; 0 if it does not fall so far. Doubling divides a loss by `fall`.
  int threshold_of_squares(double fall, double goal) const;
  // The highest class such that those up to it may stay as they are, if pixels are counted.
  int threshold_of_pixels(double goal) const;
  // The lowest class above which there are at most `pixels` pixels, or a higher
  // one if what those up to that cost is within `goal`.
  int threshold_of_most(double pixels, double goal) const;
  // That are to be taken if the threshold is this.
  double samples_above(int threshold) const;

 private:
  struct Class {
    double loss = 0, samples = 0, pixels = 0;
  };
  double left_after(double fall, int threshold) const;

  std::vector<Class> classes_;
};

}  // namespace alhazen::render
