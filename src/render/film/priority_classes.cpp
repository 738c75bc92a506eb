#include "render/film/priority_classes.h"

#include <cmath>

namespace alhazen::render {
namespace {

// Parts of an octave; 0 is for no priority at all.
constexpr int kClassesOfOctave = 16;
constexpr int kLowestOctave = -100, kHighestOctave = 60;
constexpr int kClasses = (kHighestOctave - kLowestOctave) * kClassesOfOctave + 1;

// How often pixels of class `k` are to have their samples doubled when those above `threshold` are:
// until their gain for each sample, variance over samples, which falls as 1/n^2, is the same for
// all. That is the fewest samples for the least sum of variances.
int doublings(int k, int threshold) {
  return k <= threshold ? 0 : 1 + (k - threshold - 1) / (2 * kClassesOfOctave);
}

}  // namespace

int PriorityClasses::of(double priority) {
  if (!(priority > 0)) return 0;
  int octave = 0;
  const double mantissa = std::frexp(priority, &octave);  // in [1/2, 1), exactly
  if (octave < kLowestOctave) return 1;
  if (octave >= kHighestOctave) return kClasses - 1;
  const int part = static_cast<int>((2 * mantissa - 1) * kClassesOfOctave);
  return 1 + (octave - kLowestOctave) * kClassesOfOctave + part;
}

PriorityClasses::PriorityClasses() : classes_(kClasses) {}

void PriorityClasses::add(int k, double loss, double samples) {
  Class& all = classes_[static_cast<std::size_t>(k)];
  all.loss += loss;
  all.samples += samples;
  ++all.pixels;
}

double PriorityClasses::loss() const {
  double loss = 0;
  for (const Class& all : classes_)
    loss += all.loss;
  return loss;
}

double PriorityClasses::left_after(double fall, int threshold) const {
  double left = 0;
  for (int k = 0; k < kClasses; ++k) {
    double loss = classes_[static_cast<std::size_t>(k)].loss;
    for (int n = loss > 0 ? doublings(k, threshold) : 0; n > 0; --n)
      loss /= fall;
    left += loss;
  }
  return left;
}

int PriorityClasses::threshold_of_squares(double fall, double goal) const {
  int low = 0, high = kClasses;  // what is left grows with the threshold
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    (left_after(fall, middle) <= goal ? low : high) = middle;
  }
  return low;
}

// The pixels above are to become good, those that this costs most are among the rest.
int PriorityClasses::threshold_of_pixels(double goal) const {
  constexpr double kShareOfRest = 0.8;
  double left = classes_[0].loss;
  int threshold = 0;
  while (threshold + 1 < kClasses) {
    left += classes_[static_cast<std::size_t>(threshold + 1)].loss;
    if (left > kShareOfRest * goal) break;
    ++threshold;
  }
  return threshold;
}

int PriorityClasses::threshold_of_most(double pixels, double goal) const {
  int threshold = kClasses - 1;
  double above = 0, left = loss();
  while (threshold > 0 && left > goal) {
    const Class& next = classes_[static_cast<std::size_t>(threshold)];
    if (above + next.pixels > pixels) break;
    above += next.pixels;
    left -= next.loss;
    --threshold;
  }
  return threshold;
}

double PriorityClasses::samples_above(int threshold) const {
  double samples = 0;
  for (int k = threshold + 1; k < kClasses; ++k) {
    samples += classes_[static_cast<std::size_t>(k)].samples *
               (std::ldexp(1.0, doublings(k, threshold)) - 1);
  }
  return samples;
}

}  // namespace alhazen::render
