// The same kernels on render::Lanes, on std::experimental::simd and on Highway
// (docs/decisions/0007-lanes.md): rays against a sphere, rays against a box, and a chain of fused
// products and roots. Built once for each instruction set; what a library has not got (a fused
// product that is rounded once, at the baseline) is given to it here.
#include <array>
#include <benchmark/benchmark.h>
#include <cmath>
#include <cstdint>
#include <experimental/simd>
#include <string>
#include <vector>

#include "render/simd/wide.h"
#if ALHAZEN_HAS_HIGHWAY
#include <hwy/highway.h>
#endif

namespace {

namespace stdx = std::experimental;
using alhazen::render::Wide;

// What a kernel asks of a library, by one set of names.
template <class T>
struct Ours {
  using Number = T;
  using V = Wide<T>;
  static constexpr int kWidth = V::kWidth;
  static V load(const T* p) { return V::load(p); }
  static void store(V v, T* p) { v.store(p); }
  static V all(T x) { return V(x); }
  static V fma(V a, V b, V c) { return alhazen::fused_multiply_add(a, b, c); }
  static V root(V x) { return alhazen::square_root(x); }
  static V least(V a, V b) { return smaller(a, b); }
  static V greatest(V a, V b) { return larger(a, b); }
  template <class M>
  static V choose(M m, V yes, V no) {
    return select(m, yes, no);
  }
  template <class M>
  static bool some(M m) {
    return any(m);
  }
};

template <class T>
struct Standard {
  using Number = T;
  using V = stdx::native_simd<T>;
  static constexpr int kWidth = static_cast<int>(V::size());
  static V load(const T* p) { return V(p, stdx::element_aligned); }
  static void store(V v, T* p) { v.copy_to(p, stdx::element_aligned); }
  static V all(T x) { return V(x); }
  static V fma(V a, V b, V c) { return stdx::fma(a, b, c); }
  static V root(V x) { return stdx::sqrt(x); }
  static V least(V a, V b) { return choose(b < a, b, a); }
  static V greatest(V a, V b) { return choose(a < b, b, a); }
  template <class M>
  static V choose(M m, V yes, V no) {
    stdx::where(m, no) = yes;
    return no;
  }
  template <class M>
  static bool some(M m) {
    return stdx::any_of(m);
  }
};

#if ALHAZEN_HAS_HIGHWAY
namespace hn = hwy::HWY_NAMESPACE;
// Highway has functions for operators; a struct of one member gives them back.
template <class T>
struct Highway {
  using Number = T;
  using Tag = hn::ScalableTag<T>;
  struct V {
    hn::Vec<Tag> v;
    friend V operator+(V a, V b) { return {hn::Add(a.v, b.v)}; }
    friend V operator-(V a, V b) { return {hn::Sub(a.v, b.v)}; }
    friend V operator*(V a, V b) { return {hn::Mul(a.v, b.v)}; }
    friend V operator/(V a, V b) { return {hn::Div(a.v, b.v)}; }
    friend V operator-(V a) { return {hn::Neg(a.v)}; }
    friend auto operator<(V a, V b) { return hn::Lt(a.v, b.v); }
    friend auto operator<=(V a, V b) { return hn::Le(a.v, b.v); }
  };
  static constexpr int kWidth = static_cast<int>(HWY_LANES(T));
  static V load(const T* p) { return {hn::LoadU(Tag(), p)}; }
  static void store(V v, T* p) { hn::StoreU(v.v, Tag(), p); }
  static V all(T x) { return {hn::Set(Tag(), x)}; }
  static V fma(V a, V b, V c) {
#if ALHAZEN_SIMD_AVX2
    return {hn::MulAdd(a.v, b.v, c.v)};
#else  // its MulAdd would round twice
    std::array<T, kWidth> p, q, r;
    store(a, p.data());
    store(b, q.data());
    store(c, r.data());
    for (std::size_t i = 0; i < kWidth; ++i)
      r[i] = std::fma(p[i], q[i], r[i]);
    return load(r.data());
#endif
  }
  static V root(V x) {
    return {hn::Sqrt(x.v)};
  }
  static V least(V a, V b) {
    return choose(b < a, b, a);
  }
  static V greatest(V a, V b) {
    return choose(a < b, b, a);
  }
  template <class M>
  static V choose(M m, V yes, V no) {
    return {hn::IfThenElse(m, yes.v, no.v)};
  }
  template <class M>
  static bool some(M m) {
    return !hn::AllFalse(Tag(), m);
  }
};
#endif

constexpr std::size_t kRays = 1024;

// Component by component: origins and directions in [-1, 1], and where answers go.
template <class T>
struct Rays {
  std::vector<T> ox, oy, oz, dx, dy, dz, t;
  Rays() {
    std::uint64_t state = 1;
    const auto draw = [&] {
      state = state * 6364136223846793005ULL + 1442695040888963407ULL;
      return static_cast<T>(static_cast<double>(state >> 11) * 0x1p-52 - 1);
    };
    for (std::vector<T>* component : {&ox, &oy, &oz, &dx, &dy, &dz, &t}) {
      for (std::size_t i = 0; i < kRays; ++i)
        component->push_back(draw());
    }
  }
};

// The nearer crossing with a sphere, behind a filter: most packets end at the discriminant.
template <class L>
void sphere(Rays<typename L::Number>& r, std::size_t i) {
  using V = typename L::V;
  using T = typename L::Number;
  const V ox = L::load(&r.ox[i]) - L::all(T(2)), oy = L::load(&r.oy[i]), oz = L::load(&r.oz[i]);
  const V dx = L::load(&r.dx[i]), dy = L::load(&r.dy[i]), dz = L::load(&r.dz[i]);
  const V a = L::fma(dx, dx, L::fma(dy, dy, dz * dz));
  const V b = L::fma(ox, dx, L::fma(oy, dy, oz * dz));
  const V c = L::fma(ox, ox, L::fma(oy, oy, L::fma(oz, oz, L::all(T(-0.25)))));
  const V discriminant = L::fma(b, b, -(a * c));
  const auto meets = L::all(T(0)) < discriminant;
  V t = L::all(T(-1));
  if (L::some(meets)) t = L::choose(meets, (-b - L::root(discriminant)) / a, t);
  L::store(t, &r.t[i]);
}

// Where a ray enters a box, or -1.
template <class L>
void slab(Rays<typename L::Number>& r, std::size_t i) {
  using V = typename L::V;
  using T = typename L::Number;
  V near = L::all(T(0)), far = L::all(T(1000));
  for (const auto& [o, d] : {std::pair(&r.ox[i], &r.dx[i]), std::pair(&r.oy[i], &r.dy[i]),
                             std::pair(&r.oz[i], &r.dz[i])}) {
    const V inverse = L::all(T(1)) / L::load(d), origin = L::load(o);
    const V low = (L::all(T(-0.5)) - origin) * inverse, high = (L::all(T(0.5)) - origin) * inverse;
    near = L::greatest(near, L::least(low, high));
    far = L::least(far, L::greatest(low, high));
  }
  L::store(L::choose(near <= far, near, L::all(T(-1))), &r.t[i]);
}

// Ten fused products and two roots, one after the other.
template <class L>
void chain(Rays<typename L::Number>& r, std::size_t i) {
  using V = typename L::V;
  using T = typename L::Number;
  V x = L::load(&r.ox[i]) + L::all(T(2));
  const V y = L::load(&r.oy[i]) + L::all(T(2));
  for (int round = 0; round < 2; ++round) {
    for (int k = 0; k < 5; ++k)
      x = L::fma(x, y, L::all(T(0.5)));
    x = L::root(x);
  }
  L::store(x, &r.t[i]);
}

template <class L, void (*kernel)(Rays<typename L::Number>&, std::size_t)>
void run(benchmark::State& state) {
  Rays<typename L::Number> rays;
  for (auto _ : state) {
    for (std::size_t i = 0; i < kRays; i += static_cast<std::size_t>(L::kWidth))
      kernel(rays, i);
    benchmark::DoNotOptimize(rays.t.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * kRays));
  double sum = 0;  // equal for all libraries and instruction sets, or one of them is wrong
  for (const auto t : rays.t)
    sum += static_cast<double>(t);
  state.counters["sum"] = sum;
  state.counters["lanes"] = L::kWidth;
}

template <class L>
void add(const std::string& name) {
  benchmark::RegisterBenchmark((name + "/sphere").c_str(), run<L, sphere<L>>);
  benchmark::RegisterBenchmark((name + "/slab").c_str(), run<L, slab<L>>);
  benchmark::RegisterBenchmark((name + "/chain").c_str(), run<L, chain<L>>);
}

}  // namespace

int main(int argc, char** argv) {
  add<Ours<double>>("lanes/double");
  add<Ours<float>>("lanes/float");
  add<Standard<double>>("std/double");
  add<Standard<float>>("std/float");
#if ALHAZEN_HAS_HIGHWAY
  add<Highway<double>>("highway/double");
  add<Highway<float>>("highway/float");
#endif
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
