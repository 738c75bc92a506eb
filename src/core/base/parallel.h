// core/base: work shared by several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace alhazen {

// The machine's cores where `asked` is 0, otherwise as many as asked for; at least 1.
int thread_count(int asked);

// Calls work(i) once for every i in [0, count), in no order, on up to `threads` threads of which
// the calling one is the first. Returns when all is done. What a call throws is thrown again here,
// once, and what was not begun is then left out.
void in_parallel(int threads, std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace alhazen
