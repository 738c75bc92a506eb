// render/film: which pixels of a picture need more samples for its error to be
// what was asked for, and what the error is by now. docs/accuracy.md says why it may be believed.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/scene/settings.h"
#include "render/film/error_lots.h"
#include "render/film/first_look.h"
#include "render/film/priority_classes.h"
#include "render/film/variance_fall.h"

namespace alhazen::render {

// The error of sampling, against the picture's expectation: the root of the mean square, or the
// share of pixels that are off by more than the target says.
struct ErrorEstimate {
  double value = 0;
  double bound = 0;  // with kErrorConfidence it is at most this, the picture's
                     // own luck included
};
inline constexpr double kErrorConfidence = 0.95;

// How a pixel's mean moved when its samples were doubled: `outer` is half of
// the difference of the old half's mean and the new one's, `inner` the same of
// the two parts of the new half. 0 where there are no such parts.
struct PixelChange {
  std::array<double, 3> outer{}, inner{};
};

// Samples are taken in passes over the whole picture: one of each pixel in the first. From then on
// a pixel takes as many samples as it has, or none; how far its mean moves tells what the samples
// before were worth. Everything is decided between passes from sums over all pixels in their order,
// so that neither tiles nor threads can be seen in the picture.
//
// Pixels are numbered by rows from the top left one of the window.
class ErrorControl {
 public:
  // `target.error`: what of the error is left to sampling.
  ErrorControl(const ErrorTarget& target, int width, int height, std::uint64_t seed);

  // Samples that pixel `p` is to have after the pass that is to be made.
  std::uint32_t wanted(std::size_t p) const { return wanted_[p]; }

  // The pixel has all that it wanted: its first sample, of this value, or more.
  // Different pixels may be recorded at the same time.
  void record_first(std::size_t p, const std::array<double, 3>& value);
  void record(std::size_t p, const PixelChange& change);

  // Looks at what the pass has found and plans the next, if there is to be one.
  // Pixels that were not recorded count as they were before.
  void plan_next();
  bool has_next() const { return has_next_; }
  // Whether estimate().bound is within the target. If not, and there is no next
  // pass: no pixel may take more samples.
  bool reached() const { return reached_; }
  const ErrorEstimate& estimate() const { return estimate_; }
  // From the second pass on, in which some pixels take their second sample.
  bool is_known() const { return passes_ >= 2; }
  // A guess at the samples that are still to come, for those who wait.
  double samples_ahead() const { return samples_ahead_; }

  // The standard error of the pixel's mean: RMS of its channels, or of the
  // worst one where the target counts pixels.
  double standard_error(std::size_t p) const;

 private:
  std::size_t pixel_count() const { return taken_.size(); }
  // A pixel with the halves of its samples exchanged: see ErrorLots.
  struct Exchanged {
    std::size_t pixel;
    double loss, seemed;
  };
  void look_first();
  void look_again();
  void settle();
  double own_loss(std::size_t p, double scale) const;
  std::vector<Exchanged> exchange() const;
  double smoothed(std::size_t p, double spread) const;
  void smooth_variances();
  void add_up();
  void choose();
  void choose_all();
  int class_of(double variance, std::uint32_t samples) const;
  bool is_worth_it(double variance) const;
  bool wins(std::size_t p, int level) const;

  ErrorLoss loss_;
  int width_, height_;
  std::uint64_t seed_;
  std::uint64_t first_lots_;  // of the pixels with one sample, one in so many is drawn
  int passes_ = 0;
  // Until the second pass has been looked at: the first and the second samples.
  FirstLook first_;
  std::vector<FirstLook::Value> second_;
  std::vector<std::uint32_t> taken_, wanted_;
  std::vector<std::uint8_t> is_fresh_;  // recorded in the last pass
  std::vector<std::uint8_t> weight_;  // of those that are: pixels it was drawn from, or 1 if chosen
  std::vector<float> outer_, inner_;  // PixelChange, squared
  std::vector<float> own_;            // the variance of the mean, by the last doubling alone
  std::vector<float> spread_;         // of one sample: a mean of those, older ones counting less
  std::vector<float> variance_;       // as decisions see it: with its neighbours'
  VarianceFall fall_;
  std::array<ErrorLots, kSampleLevels> lots_;
  int threshold_ = 0;  // classes of priority up to it rest
  ErrorEstimate estimate_;
  double bound_on_loss_ = 0;
  double samples_ahead_ = 0;
  bool has_next_ = true, reached_ = false;
};

}  // namespace alhazen::render
