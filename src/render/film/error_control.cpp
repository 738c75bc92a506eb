#include "render/film/error_control.h"

#include <algorithm>
#include <cmath>

#include "core/base/hash.h"

namespace alhazen::render {
namespace {

// One-sided, of the normal distribution: kErrorConfidence of it lies below.
constexpr double kQuantile = 1.645;
// Of the pixels that are not to get more samples, one in so many gets them all the same.
constexpr std::uint64_t kLots = 8;
constexpr std::uint64_t kLotteryDimension = 0x6c6f747465727921;  // no sample's

// Classes of priority, parts of an octave; 0 is for none at all.
constexpr int kClassesOfOctave = 16;
constexpr int kLowestOctave = -100, kHighestOctave = 60;
constexpr int kClasses = (kHighestOctave - kLowestOctave) * kClassesOfOctave + 1;

int class_of(double priority) {
  if (!(priority > 0)) return 0;
  int octave = 0;
  const double mantissa = std::frexp(priority, &octave);  // in [1/2, 1), exactly
  if (octave < kLowestOctave) return 1;
  if (octave >= kHighestOctave) return kClasses - 1;
  const int part = static_cast<int>((2 * mantissa - 1) * kClassesOfOctave);
  return 1 + (octave - kLowestOctave) * kClassesOfOctave + part;
}

int level_of(std::uint32_t samples) {
  int level = 0;
  while (samples > 1) {
    samples >>= 1;
    ++level;
  }
  return level;
}

// What is known of the pixels of one class.
struct PriorityClass {
  double loss = 0, samples = 0;
};

// How often pixels of class `k` are to have their samples doubled when those above `threshold` are:
// until their gain for each sample, variance over samples, which falls as 1/n^2, is the same for
// all. That is the fewest samples for the least sum of variances.
int doublings(int k, int threshold) {
  return k <= threshold ? 0 : 1 + (k - threshold - 1) / (2 * kClassesOfOctave);
}

// The sum of variances when what is above `threshold` has been doubled.
double left_after(const std::vector<PriorityClass>& classes, double fall, int threshold) {
  double left = 0;
  for (int k = 0; k < kClasses; ++k) {
    double loss = classes[static_cast<std::size_t>(k)].loss;
    for (int n = loss > 0 ? doublings(k, threshold) : 0; n > 0; --n)
      loss /= fall;
    left += loss;
  }
  return left;
}

// The highest class such that the sum of variances falls to `goal`, or 0.
int threshold_of_squares(const std::vector<PriorityClass>& classes, double fall, double goal) {
  int low = 0, high = kClasses;  // what is left grows with the threshold
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    (left_after(classes, fall, middle) <= goal ? low : high) = middle;
  }
  return low;
}

// The highest class such that those up to it may stay as they are; the pixels above are to become
// good, those that this costs most are among the rest.
int threshold_of_pixels(const std::vector<PriorityClass>& classes, double goal) {
  constexpr double kShareOfRest = 0.8;
  double left = classes[0].loss;
  int threshold = 0;
  while (threshold + 1 < kClasses) {
    left += classes[static_cast<std::size_t>(threshold + 1)].loss;
    if (left > kShareOfRest * goal) break;
    ++threshold;
  }
  return threshold;
}

// n samples do not see what covers less than 1 / n of a pixel. Missed in one pixel of 1600, and as
// bright as white, it makes an RMSE of 1 / (40 n): that much is left to chance and to the lots, up
// to 16 samples, beyond which the lots have to do.
std::uint32_t first_samples(double error) {
  std::uint32_t samples = 2;
  while (samples < 16 && 40 * samples * error < 1)
    samples *= 2;
  return samples;
}

}  // namespace

ErrorControl::ErrorControl(const ErrorTarget& target, int width, int height, std::uint64_t seed)
    : loss_(target),
      width_(width),
      height_(height),
      seed_(seed),
      first_samples_(first_samples(target.error)) {
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  taken_.assign(pixels, 0);
  wanted_.assign(pixels, 1);
  is_fresh_.assign(pixels, 0);
  for (std::vector<float>* plane : {&outer_, &inner_, &own_, &history_, &variance_})
    plane->assign(pixels, 0);
}

void ErrorControl::record(std::size_t p, const PixelChange& change) {
  const bool is_first = taken_[p] == 0;
  taken_[p] = wanted_[p];
  is_fresh_[p] = 1;
  outer_[p] = is_first ? 0.0F : static_cast<float>(loss_.squared(change.outer));
  inner_[p] = static_cast<float>(loss_.squared(change.inner));
}

// Prefixes of 2^m samples and the blocks that they are made of have means of one distribution: with
// the variance V of a block's mean, outer^2 is V(n) - V(2n) on average and inner^2 is
// V(n/2) - V(n). Where V falls by the same factor each time, it is the ratio of the two.
void ErrorControl::settle() {
  // At random samples' rate at least. Stratified edges fall as n^(-3/2), by 2.83, and what is
  // smooth faster still, but not all that is in a picture does.
  constexpr double kSlowest = 2, kFastest = 2.5;
  double outer = 0, inner = 0, squares = 0;
  for (std::size_t p = 0; p < pixel_count(); ++p) {
    if (is_fresh_[p] == 0 || taken_[p] < 4) continue;
    outer += outer_[p];
    inner += inner_[p];
    squares += double{outer_[p]} * outer_[p];
  }
  // Of a sum of terms as if there were `outer`^2 / `squares` equal ones; each is known as well as
  // its square root.
  const double doubt = outer > 0 ? square_root(squares) / outer : 1;
  fall_ = std::clamp(outer > 0 ? inner / outer * (1 - 2 * doubt) : kSlowest, kSlowest, kFastest);
  for (std::size_t p = 0; p < pixel_count(); ++p) {
    if (is_fresh_[p] == 0 || taken_[p] < 2) continue;
    const double mean = taken_[p] < 4 ? outer_[p] : 0.5 * (outer_[p] + inner_[p] / fall_);
    own_[p] = static_cast<float>(mean / (fall_ - 1));
    history_[p] =
        taken_[p] == 2 ? own_[p] : static_cast<float>(0.5 * (own_[p] + history_[p] / fall_));
  }
}

void ErrorControl::plan_next() {
  has_next_ = false;
  const std::uint32_t fewest = *std::min_element(taken_.begin(), taken_.end());
  const bool are_equal = fewest == *std::max_element(taken_.begin(), taken_.end());
  samples_of_all_ = fewest;
  settle();
  if (fewest >= 2) {
    add_up();
    // Half of them may be enough for what shows nothing at all.
    reached_ = 2 * fewest >= first_samples_ && estimate_.bound <= loss_.value(loss_.goal());
    if (reached_) {
      wanted_ = taken_;
      return;
    }
  }
  if (are_equal && fewest < first_samples_) {
    wanted_.assign(pixel_count(), 2 * fewest);
    samples_ahead_ = static_cast<double>(pixel_count()) * (first_samples_ - fewest);
    has_next_ = true;
  } else {
    choose();
  }
  std::fill(is_fresh_.begin(), is_fresh_.end(), std::uint8_t{0});
}

// Variances of means as decisions see them. One squared change says little about one pixel; half of
// what is believed comes from the pixels around, by the binomial weights 1 2 1, the pixel's own
// share of those included. An edge that was missed here was seen next door.
void ErrorControl::smooth_variances() {
  const auto at = [&](int x, int y) {
    x = std::clamp(x, 0, width_ - 1);
    y = std::clamp(y, 0, height_ - 1);
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  };
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const std::size_t p = at(x, y);
      double around = 0;  // of a pixel with one sample
      for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) {
          const std::size_t q = at(x + i, y + j);
          const int weight = (2 - std::abs(i)) * (2 - std::abs(j));
          around += weight * double{history_[q]} * taken_[q];
        }
      }
      double variance = 0.5 * (double{history_[p]} + around / 16 / taken_[p]);
      if (is_fresh_[p] == 0) variance += lots_[level_of(taken_[p])].missed_variance();
      variance_[p] = static_cast<float>(variance);
    }
  }
}

void ErrorControl::add_up() {
  for (ErrorLots& lots : lots_) {
    lots.evaluate(loss_, threshold_,
                  [&](std::size_t p) { return is_fresh_[p] != 0 ? fall_ * own_[p] : -1.0; });
  }
  std::array<double, kSampleLevels> resting{};
  double loss = 0, noise = 0;
  for (std::size_t p = 0; p < pixel_count(); ++p) {
    loss += loss_.of(own_[p]);
    noise += loss_.noise(own_[p]);
    if (is_fresh_[p] == 0) ++resting[level_of(taken_[p])];
  }
  for (std::size_t level = 0; level < kSampleLevels; ++level) {
    const double missed_noise = resting[level] * lots_[level].loss_noise();
    loss += resting[level] * lots_[level].missed_loss();
    noise += missed_noise * missed_noise;
  }
  const auto pixels = static_cast<double>(pixel_count());
  bound_on_loss_ = (loss + kQuantile * square_root(noise)) / pixels;
  estimate_.value = loss_.value(loss / pixels);
  estimate_.bound = loss_.value(bound_on_loss_);
  smooth_variances();
}

// Every pixel counts by its class alone: what would be gained for each sample that is spent.
void ErrorControl::choose() {
  std::vector<PriorityClass> classes(kClasses);
  std::vector<std::uint16_t> class_at(pixel_count(), 0);
  for (std::size_t p = 0; p < pixel_count(); ++p) {
    const double variance = variance_[p], loss = loss_.of(variance), samples = taken_[p];
    const double gain = loss_.counts_pixels() && variance > 0 ? loss / variance : variance;
    const int k = taken_[p] >= kMaxSamples ? 0 : class_of(gain / samples);
    class_at[p] = static_cast<std::uint16_t>(k);
    auto& all = classes[static_cast<std::size_t>(k)];
    all.loss += loss;
    all.samples += samples;
  }
  double loss = 0;
  for (const PriorityClass& all : classes)
    loss += all.loss;
  const double goal = loss * loss_.goal() / bound_on_loss_;
  threshold_ = loss_.counts_pixels() ? threshold_of_pixels(classes, goal)
                                     : threshold_of_squares(classes, fall_, goal);
  samples_ahead_ = 0;
  for (int k = threshold_ + 1; k < kClasses; ++k) {
    samples_ahead_ += classes[static_cast<std::size_t>(k)].samples *
                      (std::ldexp(1.0, doublings(k, threshold_)) - 1);
  }
  for (std::size_t p = 0; p < pixel_count(); ++p) {
    const int level = level_of(taken_[p]);
    const bool is_chosen = class_at[p] > threshold_ && is_worth_it(variance_[p]);
    has_next_ = has_next_ || is_chosen;
    const bool by_lot = !is_chosen && taken_[p] < kMaxSamples && wins(p, level);
    if (by_lot) lots_[static_cast<std::size_t>(level)].draw(p, class_at[p], own_[p]);
    wanted_[p] = is_chosen || by_lot ? 2 * taken_[p] : taken_[p];
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
  return mix_64(mix_64(seed_ ^ kLotteryDimension, p), static_cast<std::uint64_t>(level)) % kLots ==
         0;
}

double ErrorControl::standard_error(std::size_t p) const {
  return square_root(double{variance_[p]});
}

}  // namespace alhazen::render
