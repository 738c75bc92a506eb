// render/wave: what of a generation waits because it has grown too large to be followed at once.
#pragma once

#include <utility>
#include <vector>

#include "render/wave/ray_queue.h"

namespace alhazen::render {

// Generations of more than `comfortable` rays are cut into parts, each followed to its end before
// the next, so that the queues stay in the cache. Cuts fall between camera samples, which changes
// no sum. One sample's rays are cut only when there are more than `most` of them, at a place that
// follows from them and from nothing else.
template <class Real>
class WaitingRays {
 public:
  WaitingRays(std::size_t comfortable, std::size_t most)
      : comfortable_(std::min(comfortable, most)), most_(most) {}

  bool empty() const { return used_ == 0; }
  void clear() { used_ = 0; }

  // Leaves of `rays`, which belong to samples below `slots`, as many as are followed now.
  void set_aside(RayQueue<Real>& rays, std::size_t slots) {
    if (rays.size() <= comfortable_) return;
    group_by_sample(rays, slots);
    std::size_t end = rays.size();
    while (end > comfortable_) {
      std::size_t cut = cut_near(rays, end / 2, end);
      if (cut == 0) {
        if (end <= most_) break;
        cut = most_;
      }
      if (used_ == parts_.size()) parts_.emplace_back();
      parts_[used_++].take(rays, order_.data() + cut, end - cut);
      end = cut;
    }
    if (end == rays.size()) return;
    now_.take(rays, order_.data(), end);
    std::swap(rays, now_);
  }

  // The part that was set aside last takes the place of `rays`. Precondition: not empty().
  void resume(RayQueue<Real>& rays) { std::swap(rays, parts_[--used_]); }

 private:
  // Stages append by kind of surface, so a generation is not sorted by itself, and need not be
  // unless it is cut. Of one sample the order stays.
  void group_by_sample(const RayQueue<Real>& rays, std::size_t slots) {
    begin_.assign(slots + 1, 0);
    for (std::size_t i = 0; i < rays.size(); ++i)
      ++begin_[rays.slot[i] + 1];
    for (std::size_t s = 0; s < slots; ++s)
      begin_[s + 1] += begin_[s];
    order_.resize(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i)
      order_[begin_[rays.slot[i]]++] = static_cast<std::uint32_t>(i);
  }

  // A place near `near` and before `end` at which another sample's rays begin; 0 if there is none.
  std::size_t cut_near(const RayQueue<Real>& rays, std::size_t near, std::size_t end) const {
    const auto begins = [&](std::size_t k) {
      return rays.slot[order_[k - 1]] != rays.slot[order_[k]];
    };
    std::size_t below = near;
    while (below > 0 && !begins(below))
      --below;
    if (below > 0) return below;
    std::size_t above = near + 1;
    while (above < end && !begins(above))
      ++above;
    return above < end ? above : 0;
  }

  std::size_t comfortable_, most_;
  std::vector<RayQueue<Real>> parts_;  // the first used_ of them wait; the others keep their memory
  std::size_t used_ = 0;
  RayQueue<Real> now_;
  std::vector<std::uint32_t> order_, begin_;
};

}  // namespace alhazen::render
