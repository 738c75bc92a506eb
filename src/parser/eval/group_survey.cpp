#include "parser/eval/group_survey.h"

#include <limits>

namespace alhazen::parser {
namespace {

// Groups of groups double with each step: sums stop at the largest number.
void add(std::uint64_t& sum, std::uint64_t more) {
  sum = more > std::numeric_limits<std::uint64_t>::max() - sum
            ? std::numeric_limits<std::uint64_t>::max()
            : sum + more;
}

// Calls visit(inner) for each group among the children, as often as it is there.
template <class Visit>
void for_each_inner(const Group& group, const Visit& visit) {
  group.children.for_each_group([&](const std::shared_ptr<const Group>& inner) { visit(*inner); });
}

}  // namespace

GroupSurvey::GroupSurvey(const Group& root) {
  count(root);
  facts_[&root].places = 1;
  for (std::size_t i = inner_first_.size(); i-- > 0;) {
    const std::uint64_t places = facts_[inner_first_[i]].places;
    for_each_inner(*inner_first_[i],
                   [&](const Group& inner) { add(facts_[&inner].places, places); });
  }
  for (const Group* group : inner_first_) {
    Facts& facts = facts_[group];
    for_each_inner(*group, [&](const Group& inner) {
      const Facts& its = facts_[&inner];
      facts.repeats =
          facts.repeats || its.repeats || (its.mentions > 1 && its.shapes >= kLeastShared);
    });
  }
}

// As deep as objects nest (BlockBuilder bounds it).
void GroupSurvey::count(const Group& group) {
  if (!facts_.try_emplace(&group).second) return;
  std::uint64_t shapes = group.children.size(), groups = 0;
  std::uint64_t inside = 0;
  for_each_inner(group, [&](const Group& inner) {
    count(inner);
    Facts& its = facts_[&inner];
    ++its.mentions;
    ++groups;
    add(inside, its.shapes);
  });
  shapes -= groups;
  add(shapes, inside);
  facts_[&group].shapes = shapes;
  inner_first_.push_back(&group);
}

bool GroupSurvey::is_shared(const Group& group) const {
  const Facts& facts = facts_.at(&group);
  return facts.places > 1 && facts.shapes >= kLeastShared &&
         !(facts.shapes > kMostSharedWhole && facts.repeats);
}

}  // namespace alhazen::parser
