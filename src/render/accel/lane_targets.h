// render/accel: what lanes of rays look for, and what they have found so far.
#pragma once

#include "render/accel/hit_lanes.h"
#include "render/accel/shape_hits.h"

namespace alhazen::render {

// The rays as they were asked about. Shapes is a ShapeTable or the WorldShapes, the rays are in its
// frame. source_of(lane) gives the Source of a lane.
template <class L, class Shapes, class SourceOf>
struct LaneQuery {
  using Real = ScalarOf<L>;

  const Shapes& shapes;
  const Ray<L>& ray;
  const DepartureLanes<L>& from;
  const SourceOf& source_of;
  IntOf<L> ignored;
  // Shapes that a lane is not tested against on its way: those that rays leave.
  IntOf<L> left = select(from.face == IntOf<L>(kNoFace), IntOf<L>(-1), from.shape);

  // shape_hits.h, of a lane.
  bool is_ahead(int lane, ShapeId id, const Crossing<Real>& crossing) const {
    return render::is_ahead(shapes, one_ray(ray, lane), source_of(lane), id, crossing);
  }
  // Lanes of crossings with a shape less those at t = 0 which are behind their rays.
  MaskOf<L> ahead(const IntOf<L>& shape, const Crossing<L>& crossing, MaskOf<L> exists) const {
    const MaskOf<L> at_start = exists && crossing.t == L(0);
    if (!any(at_start)) return exists;
    std::uint32_t behind = 0;
    for_each_lane(at_start, [&](int i) {
      const Crossing<Real> one{crossing.t[i], static_cast<int>(crossing.face[i]),
                               crossing.enters[i]};
      if (!is_ahead(i, static_cast<ShapeId>(shape[i]), one)) behind |= std::uint32_t{1} << i;
    });
    return exists && !MaskOf<L>::from_bits(behind);
  }

  // Lanes that are to be tested against a shape.
  MaskOf<L> asking(ShapeId id, MaskOf<L> lanes) const {
    const IntOf<L> shape(static_cast<ScalarOf<IntOf<L>>>(id));
    return lanes && left != shape && ignored != shape;
  }
  // Hands the hits of a shape to what is looked for.
  template <class Targets>
  void give(const CrossingPair<L>& pair, const IntOf<L>& shape, MaskOf<L> lanes,
            Targets& targets) const {
    give(pair.near, shape, lanes && pair.has_near, targets);
    give(pair.far, shape, lanes && pair.has_far, targets);
  }
  template <class Targets>
  void give(const Crossing<L>& crossing, const IntOf<L>& shape, MaskOf<L> exists,
            Targets& targets) const {
    const MaskOf<L> wanted = exists && targets.may_take(crossing.t);
    if (!any(wanted)) return;
    targets.take(
        {crossing.t, shape, crossing.face, crossing.enters, ahead(shape, crossing, wanted)});
  }
};

template <class L, class Shapes, class SourceOf>
inline LaneQuery<L, Shapes, SourceOf> query_of(const Shapes& shapes, const Ray<L>& ray,
                                               const DepartureLanes<L>& from,
                                               const SourceOf& source_of, IntOf<L> ignored) {
  return {shapes, ray, from, source_of, ignored};
}

// The first hit in the order of precedes(), after the one that `previous` has found, if it is
// asked for.
template <class L>
class FirstHits {
 public:
  FirstHits(L t_max, MaskOf<L> active, const HitLanes<L>* previous)
      : limit_(t_max), active_(active), previous_(previous) {
    best_.found = false;
    best_.shape = IntOf<L>(-1);
    best_.face = IntOf<L>(kNoFace);
    best_.enters = false;
  }

  const HitLanes<L>& found() const { return best_; }
  MaskOf<L> wanting() const { return active_; }
  const L& limit() const { return limit_; }  // hits beyond it do not matter
  L start() const { return previous_ == nullptr ? L(0) : previous_->t; }

  // Whether a lane would take a crossing at t, but for those of one t.
  MaskOf<L> may_take(const L& t) const {
    const MaskOf<L> wanted = active_ && t <= limit_;
    return previous_ == nullptr ? wanted : wanted && t >= previous_->t;
  }
  void take(const HitLanes<L>& hit) {
    MaskOf<L> better = hit.found && hit.t <= limit_;
    if (previous_ != nullptr) {
      const MaskOf<L> tie = better && hit.t == previous_->t;
      if (any(tie)) better = better && (!tie || precedes_at_one_place(*previous_, hit));
    }
    const MaskOf<L> tie = better && best_.found && hit.t == best_.t;
    if (any(tie)) better = better && (!tie || precedes_at_one_place(hit, best_));
    limit_ = select(better, hit.t, limit_);
    best_.t = select(better, hit.t, best_.t);
    best_.shape = select(better, hit.shape, best_.shape);
    best_.face = select(better, hit.face, best_.face);
    best_.enters = (better && hit.enters) || (!better && best_.enters);
    best_.found = best_.found || better;
  }

  // One lane on its own: takes single hits until it is done.
  class One {
   public:
    using Real = ScalarOf<L>;
    One(FirstHits& all, int lane) : all_(all), lane_(lane), limit_(all.limit_[lane]) {
      if (all.best_.found[lane]) best_ = all.best_[lane];
    }
    ~One() {
      if (!changed_) return;
      all_.best_.set(lane_, *best_);
      all_.limit_.set(lane_, limit_);
    }
    One(const One&) = delete;
    One& operator=(const One&) = delete;
    const Real& limit() const { return limit_; }
    bool take(const Hit<Real>& hit) {
      const bool late = all_.previous_ == nullptr || precedes((*all_.previous_)[lane_], hit);
      if (late && (!best_ || precedes(hit, *best_))) {
        best_ = hit;
        limit_ = hit.t;
        changed_ = true;
      }
      return true;
    }

   private:
    FirstHits& all_;
    int lane_;
    Real limit_;
    std::optional<Hit<Real>> best_;
    bool changed_ = false;
  };

 private:
  L limit_;
  MaskOf<L> active_;
  const HitLanes<L>* previous_;
  HitLanes<L> best_;
};

// Any hit.
template <class L>
class AnyHits {
 public:
  AnyHits(L t_max, MaskOf<L> active) : limit_(t_max), active_(active) {}

  MaskOf<L> found() const { return found_; }
  MaskOf<L> wanting() const { return active_ && !found_; }
  const L& limit() const { return limit_; }
  L start() const { return L(0); }
  MaskOf<L> may_take(const L& t) const { return wanting() && t <= limit_; }
  void take(const HitLanes<L>& hit) { found_ = found_ || hit.found; }

  class One {
   public:
    using Real = ScalarOf<L>;
    One(AnyHits& all, int lane) : all_(all), lane_(lane), limit_(all.limit_[lane]) {}
    const Real& limit() const { return limit_; }
    bool take(const Hit<Real>&) {
      all_.found_ = all_.found_ || MaskOf<L>::from_bits(std::uint32_t{1} << lane_);
      return false;
    }

   private:
    AnyHits& all_;
    int lane_;
    Real limit_;
  };

 private:
  L limit_;
  MaskOf<L> active_, found_ = false;
};

}  // namespace alhazen::render
