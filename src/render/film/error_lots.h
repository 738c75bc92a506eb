// render/film: a check on the pixels that are not to get more samples.
#pragma once

#include <cstddef>
#include <vector>

#include "render/film/error_loss.h"

namespace alhazen::render {

// A pixel that moved little gets no more samples, so those that rest are those that happened to
// move little: by themselves they look better than they are. Of all that rest with equally many
// samples some, drawn by lot, go on nevertheless. How far those move is not biased by the choice,
// and says what the others were taken for too little.
class ErrorLots {
 public:
  // Pixel `p` is drawn; the variance of its mean seems to be `variance`, and it stands in that
  // class of priority.
  void draw(std::size_t p, int priority, double variance) {
    open_.push_back({p, priority, variance});
  }

  // Takes what that variance, with the samples that the drawn pixels had then, has turned out to
  // be: found(p), negative for pixels that have not gone on. Only what was drawn from classes up to
  // `threshold` still stands for those that rest.
  template <class Found>
  void evaluate(const ErrorLoss& loss, int threshold, const Found& found);

  // What a pixel's loss and variance are above what it seems, and the standard error of
  // that mean. At least 0.
  double missed_loss() const { return missed_loss_; }
  double missed_variance() const { return missed_variance_; }
  double loss_noise() const { return loss_noise_; }

 private:
  struct Drawn {
    std::size_t pixel;
    int priority;
    double variance;
  };
  struct Result {
    int priority;
    double loss, variance;  // differences
  };
  std::vector<Drawn> open_;
  std::vector<Result> results_;
  double missed_loss_ = 0, missed_variance_ = 0, loss_noise_ = 0;
};

template <class Found>
void ErrorLots::evaluate(const ErrorLoss& loss, int threshold, const Found& found) {
  for (const Drawn& drawn : open_) {
    const double later = found(drawn.pixel);
    if (later < 0) continue;
    results_.push_back(
        {drawn.priority, loss.of(later) - loss.of(drawn.variance), later - drawn.variance});
  }
  open_.clear();
  double count = 0, sum = 0, squares = 0, variances = 0, variance_squares = 0;
  for (const Result& result : results_) {
    if (result.priority > threshold) continue;
    ++count;
    sum += result.loss;
    squares += result.loss * result.loss;
    variances += result.variance;
    variance_squares += result.variance * result.variance;
  }
  missed_loss_ = missed_variance_ = loss_noise_ = 0;
  if (count == 0) return;
  missed_loss_ = larger(0.0, sum / count);
  loss_noise_ = square_root(squares) / count;
  missed_variance_ = larger(0.0, variances / count + square_root(variance_squares) / count);
}

}  // namespace alhazen::render
