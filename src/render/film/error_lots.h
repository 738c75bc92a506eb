// render/film: a check on the pixels that are not to get more samples.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/math/scalar.h"

namespace alhazen::render {

// What a sum of squares may be, most of them small and few large, if it came out as `sum` with that
// variance: one-sided, with kErrorConfidence. As a number of events, each of which adds `typical`
// (E. B. Wilson, JASA 22, 1927).
inline double upper_bound(double sum, double variance, double typical) {
  constexpr double kQuantile = 1.645;  // of the normal distribution
  const double half = kQuantile * typical / 2;
  return sum + kQuantile * (half + square_root(variance + half * half));
}

// A pixel that moved little gets no more samples, so those that rest are those that happened to
// move little: by themselves they look better than they are. Of all that rest with equally many
// samples some, drawn by lot, go on nevertheless. How far those move is not biased by the choice,
// and says what the others were taken for too little.
class ErrorLots {
 public:
  struct Found {
    double loss, variance;
  };
  // What has been found of a pixel that stands for those that rest and seemed to have a variance of
  // `seemed`: by how much its loss and its variance are above what was believed.
  struct Result {
    double seemed = 0, loss = 0, variance = 0;
  };
  void add_drawn(const Result& result) { drawn_.push_back(result); }
  // The two halves of a pixel's samples might as well have come the other way round. For what is
  // small and bright and was met by the first, so that the pixel was chosen, and not by the second,
  // there is as much elsewhere, on average, that the second would meet and the first has missed:
  // among the pixels that rest. Few of those are drawn, all that were chosen are seen; so such a
  // pixel, with its halves exchanged, stands for one that rests.
  void add_exchanged(const Result& result) { exchanged_.push_back(result); }

  // Pixel `p` is drawn. Its own loss is believed to be `loss`, its variance `seemed`.
  void draw(std::size_t p, double loss, double seemed) { open_.push_back({p, loss, seemed}); }

  // Those that are like what has now been chosen no longer stand for those that rest.
  template <class IsChosen>  // bool(double seemed)
  void forget(const IsChosen& is_chosen) {
    for (auto* results : {&drawn_, &exchanged_})
      std::erase_if(*results, [&](const Result& result) { return is_chosen(result.seemed); });
  }

  // Takes what the drawn pixels' loss and variance, with the samples that they had then, have
  // turned out to be: found(p), nothing for pixels that have not gone on. `resting` pixels rest.
  template <class Find>  // std::optional<Found>(std::size_t)
  void evaluate(double resting, const Find& find);

  // By how much the loss of all that rest is above what they believe themselves: by what was drawn,
  // or as far as that does not speak against it by what was exchanged, which is more; at least 0.
  // And the variance of that sum.
  double missed_loss() const { return missed_loss_; }
  double loss_noise() const { return loss_noise_; }
  // By how much the variance of each is above what it seemed, at least 0.
  double missed_variance() const { return missed_variance_; }

 private:
  struct Drawn {
    std::size_t pixel;
    double loss, seemed;
  };
  std::vector<Drawn> open_;
  std::vector<Result> drawn_, exchanged_;
  struct Sums {
    double loss = 0, loss_squares = 0, variance = 0, squares = 0;
  };
  static Sums sum_up(const std::vector<Result>& results, double weight) {
    Sums sums;
    for (const Result& result : results) {
      sums.loss += weight * result.loss;
      sums.loss_squares += weight * weight * result.loss * result.loss;
      sums.variance += weight * result.variance;
      sums.squares += weight * weight * result.variance * result.variance;
    }
    return sums;
  }
  double missed_loss_ = 0, missed_variance_ = 0, loss_noise_ = 0;
};

template <class Find>
void ErrorLots::evaluate(double resting, const Find& find) {
  for (const Drawn& drawn : open_) {
    const std::optional<Found> found = find(drawn.pixel);
    if (!found) continue;
    drawn_.push_back({drawn.seemed, found->loss - drawn.loss, found->variance - drawn.seemed});
  }
  open_.clear();
  missed_loss_ = missed_variance_ = loss_noise_ = 0;
  if (resting == 0 || (drawn_.empty() && exchanged_.empty())) return;
  const double weight = drawn_.empty() ? 0 : resting / static_cast<double>(drawn_.size());
  const Sums drawn = sum_up(drawn_, weight), exchanged = sum_up(exchanged_, 1);
  missed_loss_ = larger(0.0, drawn.loss);
  loss_noise_ = drawn.loss_squares;
  missed_variance_ = larger(0.0, drawn.variance + square_root(drawn.squares)) / resting;
  // What is drawn is enough if it has met that many events.
  constexpr double kEnough = 8;
  const bool is_enough = drawn.loss > 0 && drawn.loss * drawn.loss >= kEnough * drawn.loss_squares;
  if (is_enough || !(exchanged.loss > missed_loss_)) return;
  const double typical = weight * exchanged.loss_squares / exchanged.loss;
  const double highest = upper_bound(missed_loss_, drawn.loss_squares, typical);
  const double share = drawn_.empty() ? 1 : smaller(1.0, highest / exchanged.loss);
  missed_loss_ = larger(missed_loss_, share * exchanged.loss);
  loss_noise_ = larger(loss_noise_, exchanged.loss_squares);
  missed_variance_ = larger(missed_variance_, share * exchanged.variance / resting);
}

}  // namespace alhazen::render
