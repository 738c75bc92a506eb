// parser/eval: the nodes of a group, packed.
#include "parser/eval/object.h"

#include "core/base/overloaded.h"

namespace alhazen::parser {

template <class Content>
void NodeList::append(Content content, MaterialId material) {
  if (runs_.empty() || !std::holds_alternative<Run<Content>>(runs_.back())) {
    runs_.emplace_back(Run<Content>());
  }
  const auto placing = static_cast<std::uint32_t>(placings_.size() - 1);
  std::get<Run<Content>>(runs_.back()).push_back({std::move(content), material, placing});
}

void NodeList::push_back(Node&& node) {
  if (placings_.empty() || !(placings_.back() == node.placing)) {
    placings_.push_back(std::move(node.placing));
  }
  std::visit(Overloaded{[&](Geometry& geometry) {
                          std::visit([&](const auto& kind) { append(kind, node.material); },
                                     geometry);
                        },
                        [&](auto& content) { append(std::move(content), node.material); }},
             node.content);
  ++size_;
}

}  // namespace alhazen::parser
