// render/wave: how often the samples of a pixel saw each thing.
#pragma once

#include <algorithm>
#include <vector>

#include "render/wave/render.h"

namespace alhazen::render {

class CoverageCounter {
 public:
  void clear() { counts_.clear(); }

  void add(std::uint32_t id) {
    for (Count& count : counts_) {
      if (count.id == id) {
        ++count.samples;
        return;
      }
    }
    counts_.push_back({id, 1});
  }

  // Shares of `total` samples, largest first; of equal shares the lower id.
  std::vector<Coverage> shares(std::uint32_t total) const {
    std::vector<Count> sorted = counts_;
    std::sort(sorted.begin(), sorted.end(), [](const Count& a, const Count& b) {
      return a.samples != b.samples ? a.samples > b.samples : a.id < b.id;
    });
    std::vector<Coverage> shares;
    for (const Count& count : sorted) {
      shares.push_back({count.id, static_cast<float>(count.samples) / static_cast<float>(total)});
    }
    return shares;
  }

 private:
  struct Count {
    std::uint32_t id, samples;
  };
  std::vector<Count> counts_;  // a pixel sees few things: a list beats a map
};

}  // namespace alhazen::render
