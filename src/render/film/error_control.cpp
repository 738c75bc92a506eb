#include "render/film/error_control.h"

#include <algorithm>
#include <cmath>

#include "core/base/hash.h"

namespace alhazen::render {
namespace {

// Of the pixels that are not to get more samples, one in so many gets them all the same.
constexpr std::uint8_t kLots = 8;
// Of the pixels with one sample some more, if the picture is so small that
// fewer than this would be drawn of all.
constexpr std::uint64_t kFewestDrawn = 256;
// Every pixel gets this share of the mean number of samples.
constexpr double kShareOfMean = 1.0 / 16;
constexpr std::uint64_t kLotteryDimension = 0x6c6f747465727921;  // no sample's

int level_of(std::uint32_t samples) {
  int level = 0;
  while (samples > 1) {
    samples >>= 1;
    ++level;
  }
  return level;
}

}  // namespace

ErrorControl::ErrorControl(const ErrorTarget& target, int width, int height, std::uint64_t seed)
    : loss_(target), width_(width), height_(height), seed_(seed), first_(loss_, width, height) {
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  first_lots_ = std::clamp<std::uint64_t>(pixels / kFewestDrawn, 1, kLots);
  taken_.assign(pixels, 0);
  wanted_.assign(pixels, 1);
  is_fresh_.assign(pixels, 0);
  weight_.assign(pixels, 1);
  for (std::vector<float>* plane : {&outer_, &inner_, &own_, &spread_, &variance_})
    plane->assign(pixels, 0);
}

void ErrorControl::record_first(std::size_t p, const std::array<double, 3>& value) {
  taken_[p] = 1;
  first_.set(p, {static_cast<float>(value[0]), static_cast<float>(value[1]),
                 static_cast<float>(value[2])});
}

void ErrorControl::record(std::size_t p, const PixelChange& change) {
  if (passes_ == 1) {
    for (std::size_t c = 0; c < 3; ++c)
      second_[p][c] = static_cast<float>(first_.value(p)[c] - 2 * change.outer[c]);
  }
  taken_[p] = wanted_[p];
  is_fresh_[p] = 1;
  outer_[p] = static_cast<float>(loss_.squared(change.outer));
  inner_[p] = static_cast<float>(loss_.squared(change.inner));
}

void ErrorControl::plan_next() {
  has_next_ = reached_ = false;
  if (++passes_ == 1) {
    look_first();
  } else {
    const std::vector<Exchanged> exchanged = exchange();
    settle();
    if (passes_ == 2) look_again();
    for (const Exchanged& e : exchanged) {
      const int level = level_of(taken_[e.pixel]);
      const double found = fall_.factor(level) * own_[e.pixel];
      lots_[static_cast<std::size_t>(level - 1)].add_exchanged(
          {e.seemed, own_loss(e.pixel, fall_.factor(level)) - e.loss, found - e.seemed});
    }
    add_up();
    reached_ = estimate_.bound <= loss_.value(loss_.goal());
    if (reached_) {
      wanted_ = taken_;
      return;
    }
    choose();
  }
  std::fill(is_fresh_.begin(), is_fresh_.end(), std::uint8_t{0});
}

// A second sample goes to the pixels that differ most from their neighbours, as
// far as that can matter, and to some of the others, drawn by lot.
void ErrorControl::look_first() {
  constexpr double kMost = 1.0 / 8, kShareOfGoal = 0.25;
  const auto pixels = static_cast<double>(pixel_count());
  PriorityClasses classes;
  std::vector<int> class_at;
  for (std::size_t p = 0; p < pixel_count(); ++p) {
    const double difference = first_.difference(p);
    class_at.push_back(class_of(difference, 1));
    classes.add(class_at.back(), loss_.of(difference), 1);
  }
  threshold_ = classes.threshold_of_most(kMost * pixels, kShareOfGoal * pixels * loss_.goal());
  for (std::size_t p = 0; p < pixel_count(); ++p) {
    const bool is_chosen = class_at[p] > threshold_;
    wanted_[p] = is_chosen || wins(p, 0) ? 2 : 1;
    weight_[p] = static_cast<std::uint8_t>(is_chosen ? 1 : first_lots_);
  }
  second_.resize(pixel_count());
  has_next_ = true;
}

// What the second samples tell of the pixels that have none. The ratio of
// variances to differences of neighbours turns these into variances; a pixel
// that was drawn counts for as many as it was drawn from.
void ErrorControl::look_again() {
  double variance = 0, difference = 0;
  for (std::size_t p = 0; p < pixel_count(); ++p) {
    if (is_fresh_[p] == 0) continue;
    const double here = first_.difference(p);
    variance += weight_[p] * fall_.factor(1) * own_[p];
    difference += weight_[p] * here;
  }
  const double ratio = difference > 0 ? variance / difference : 0;
  for (std::size_t p = 0; p < pixel_count(); ++p) {
    const double seemed = ratio * first_.difference(p);
    if (is_fresh_[p] == 0) {
      spread_[p] = static_cast<float>(seemed);
      continue;
    }
    const double found = fall_.factor(1) * own_[p], loss = own_loss(p, fall_.factor(1));
    const double other = first_.difference(p, second_[p]);
    if (class_of(first_.difference(p), 1) <= threshold_) {
      lots_[0].add_drawn({seemed, loss, found - seemed});
    } else if (class_of(other, 1) <= threshold_) {
      lots_[0].add_exchanged({ratio * other, loss, found - ratio * other});
    }
  }
  first_.forget();
  second_ = {};
}

// Prefixes of 2^m samples and the blocks that they are made of have means of
// one distribution: with the variance V of a block's mean, outer^2 is V(n) -
// V(2n) on average and inner^2 is V(n/2) - V(n).
void ErrorControl::settle() {
  for (std::size_t p = 0; p < pixel_count(); ++p) {
    if (is_fresh_[p] != 0 && taken_[p] >= 4)
      fall_.add(level_of(taken_[p]), weight_[p], outer_[p], inner_[p]);
  }
  fall_.settle();
  for (std::size_t p = 0; p < pixel_count(); ++p) {
    if (taken_[p] < 2) continue;
    const double factor = fall_.factor(level_of(taken_[p]));
    const double mean = taken_[p] < 4 ? outer_[p] : 0.5 * (outer_[p] + inner_[p] / factor);
    own_[p] = static_cast<float>(mean / (factor - 1));
    if (is_fresh_[p] == 0) continue;
    const double now = double{own_[p]} * taken_[p];
    spread_[p] = static_cast<float>(taken_[p] == 2 ? now : 0.5 * (now + 2 * spread_[p] / factor));
  }
}

// What a pixel's last doubling says of its loss, if its variance were `scale` times what it is.
double ErrorControl::own_loss(std::size_t p, double scale) const {
  if (taken_[p] < 2) return 0;
  const double factor = fall_.factor(level_of(taken_[p])), by = scale / (factor - 1);
  const double loss = loss_.of_square(outer_[p] * by);
  return taken_[p] < 4 ? loss : 0.5 * (loss + loss_.of_square(inner_[p] / factor * by));
}

// Pixels that were chosen, and that would not have been for what the new half
// of their samples shows.
std::vector<ErrorControl::Exchanged> ErrorControl::exchange() const {
  std::vector<Exchanged> exchanged;
  for (std::size_t p = 0; p < pixel_count(); ++p) {
    const std::uint32_t half = taken_[p] / 2;
    if (is_fresh_[p] == 0 || half < 2 || weight_[p] > 1) continue;
    const int level = level_of(half);
    const double own = inner_[p] / (fall_.factor(level) - 1);
    const double seemed = smoothed(p, own * half) / half;
    if (class_of(seemed, half) <= threshold_)
      exchanged.push_back({p, loss_.of_square(own), seemed});
  }
  return exchanged;
}

// Variances of means as decisions see them. One squared change says little about one pixel; half of
// what is believed comes from the pixels around, by the binomial weights 1 2 1, the pixel's own
// share of those included. An edge that was missed here was seen next door. This is for one sample
// of pixel `p`, if its own is `spread`.
double ErrorControl::smoothed(std::size_t p, double spread) const {
  const int y = static_cast<int>(p / static_cast<std::size_t>(width_));
  const int x = static_cast<int>(p % static_cast<std::size_t>(width_));
  double around = 0;
  for (int j = -1; j <= 1; ++j) {
    for (int i = -1; i <= 1; ++i) {
      const auto row = static_cast<std::size_t>(std::clamp(y + j, 0, height_ - 1));
      const auto column = static_cast<std::size_t>(std::clamp(x + i, 0, width_ - 1));
      const std::size_t q = row * static_cast<std::size_t>(width_) + column;
      around += (2 - std::abs(i)) * (2 - std::abs(j)) * (q == p ? spread : double{spread_[q]});
    }
  }
  return 0.5 * (spread + around / 16);
}

void ErrorControl::smooth_variances() {
  for (std::size_t p = 0; p < pixel_count(); ++p) {
    double variance = smoothed(p, spread_[p]) / taken_[p];
    if (is_fresh_[p] == 0)
      variance += lots_[static_cast<std::size_t>(level_of(taken_[p]))].missed_variance();
    variance_[p] = static_cast<float>(variance);
  }
}

void ErrorControl::add_up() {
  std::array<double, kSampleLevels> resting{}, losses{};
  double noise = 0;
  for (std::size_t p = 0; p < pixel_count(); ++p) {
    const auto level = static_cast<std::size_t>(level_of(taken_[p]));
    const double own = own_loss(p, 1);
    losses[level] += own;
    noise += loss_.noise(own, double{spread_[p]} / taken_[p]);
    if (is_fresh_[p] == 0) ++resting[level];
  }
  double loss = 0, doubt = 0;
  for (std::size_t level = 0; level < kSampleLevels; ++level) {
    ErrorLots& lots = lots_[level];
    lots.evaluate(resting[level], [&](std::size_t p) -> std::optional<ErrorLots::Found> {
      if (is_fresh_[p] == 0) return std::nullopt;
      const double factor = fall_.factor(level_of(taken_[p]));
      return ErrorLots::Found{own_loss(p, factor), factor * own_[p]};
    });
    const double by_factor = losses[level] * fall_.doubt(static_cast<int>(level));
    doubt += by_factor * by_factor;
    noise += lots.loss_noise();
    loss += losses[level] + lots.missed_loss();
  }
  const auto pixels = static_cast<double>(pixel_count());
  bound_on_loss_ = upper_bound(loss, noise + doubt, loss > 0 ? noise / loss : 0) / pixels;
  estimate_.value = loss_.value(loss / pixels);
  estimate_.bound = loss_.value(bound_on_loss_);
  smooth_variances();
}

int ErrorControl::class_of(double variance, std::uint32_t samples) const {
  if (samples >= kMaxSamples) return 0;
  const double gain =
      loss_.counts_pixels() && variance > 0 ? loss_.of(variance) / variance : variance;
  return PriorityClasses::of(gain / samples);
}

// Every pixel counts by its class alone: what would be gained for each sample that is spent.
void ErrorControl::choose() {
  PriorityClasses classes;
  double samples = 0, weighted_fall = 0;
  for (std::size_t p = 0; p < pixel_count(); ++p) {
    const double loss = loss_.of(variance_[p]);
    classes.add(class_of(variance_[p], taken_[p]), loss, taken_[p]);
    samples += taken_[p];
    weighted_fall += loss * fall_.factor(std::min(level_of(taken_[p]) + 1, kSampleLevels - 1));
  }
  // The bound comes nearer to the estimate as more is known: of the last part
  // of the way only half is gone at once.
  const double share = loss_.goal() / bound_on_loss_;
  const double loss = classes.loss();
  const double goal = loss * std::min(square_root(share), square_root(2.0) * share);
  threshold_ = loss_.counts_pixels()
                   ? classes.threshold_of_pixels(goal)
                   : classes.threshold_of_squares(loss > 0 ? weighted_fall / loss : 2, goal);
  samples_ahead_ = classes.samples_above(threshold_);
  const double fewest = kShareOfMean * samples / static_cast<double>(pixel_count());
  const auto is_chosen = [&](double variance, std::uint32_t taken) {
    return 2 * taken <= fewest || (class_of(variance, taken) > threshold_ && is_worth_it(variance));
  };
  for (int level = 0; level < kSampleLevels; ++level) {
    lots_[static_cast<std::size_t>(level)].forget(
        [&](double variance) { return is_chosen(variance, 1U << level); });
  }
  for (std::size_t p = 0; p < pixel_count(); ++p) {
    const int level = level_of(taken_[p]);
    const bool chosen = is_chosen(variance_[p], taken_[p]);
    has_next_ = has_next_ || chosen;
    const bool by_lot = !chosen && taken_[p] < kMaxSamples && wins(p, level);
    if (by_lot) lots_[static_cast<std::size_t>(level)].draw(p, own_loss(p, 1), variance_[p]);
    wanted_[p] = chosen || by_lot ? 2 * taken_[p] : taken_[p];
    weight_[p] = by_lot ? kLots : 1;
  }
  if (!has_next_) choose_all();
}

// All that is not known exactly, if no choice is left by class.
void ErrorControl::choose_all() {
  for (std::size_t p = 0; p < pixel_count(); ++p) {
    const bool may_grow = variance_[p] > 0 && taken_[p] < kMaxSamples;
    wanted_[p] = may_grow ? 2 * taken_[p] : taken_[p];
    has_next_ = has_next_ || may_grow;
  }
}

// Where pixels are counted, some that are chosen by class are good enough already.
bool ErrorControl::is_worth_it(double variance) const {
  constexpr double kSmallShare = 0.1;
  return !loss_.counts_pixels() || loss_.of(variance) > kSmallShare * loss_.goal();
}

bool ErrorControl::wins(std::size_t p, int level) const {
  const std::uint64_t number =
      mix_64(mix_64(seed_ ^ kLotteryDimension, p), static_cast<std::uint64_t>(level));
  return number % (level == 0 ? first_lots_ : kLots) == 0;
}

double ErrorControl::standard_error(std::size_t p) const {
  return square_root(double{variance_[p]});
}

}  // namespace alhazen::render
