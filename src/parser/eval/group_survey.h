// parser/eval: which groups of what is placed are kept once, however often they are placed.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "parser/eval/object.h"

namespace alhazen::parser {

// A group of fewer shapes costs less written out: a box in a second tree, a map of every ray.
inline constexpr std::uint64_t kLeastShared = 16;
// A group of more shapes than this, with groups in it that are placed several times, is not kept as
// a whole: its parts are.
inline constexpr std::uint64_t kMostSharedWhole = 1 << 16;

class GroupSurvey {
 public:
  // Visits each group once, however many ways lead to it.
  explicit GroupSurvey(const Group& root);

  // Whether the group is to be kept once, with a transform for each of its places.
  bool is_shared(const Group& group) const;

 private:
  struct Facts {
    std::uint64_t shapes = 0;  // written out, with lights
    std::uint64_t places = 0;  // in the whole scene, all ways to it together
    std::uint64_t mentions = 0;
    bool repeats = false;  // holds groups that are mentioned more than once
  };

  void count(const Group& group);

  std::unordered_map<const Group*, Facts> facts_;
  std::vector<const Group*> inner_first_;  // no group before those in it
};

}  // namespace alhazen::parser
