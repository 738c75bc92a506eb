// app/povray: the scenes of a folder that are held to a tolerance of their own, and why.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "app/povray/judge.h"
#include "core/base/result.h"

namespace alhazen {

using Allowances = std::map<std::string, Allowance, std::less<>>;

// JSON: {"metal.scn": {"rmse": 0.01, "reason": "..."}}; `name` is the file in messages. Every entry
// has both, the RMSE is positive, and there is nothing else: ErrorCode::usage otherwise.
Result<Allowances> parse_allowances(std::string_view text, std::string_view name);

}  // namespace alhazen
