// SPDX-License-Identifier: Apache-2.0
#include <tbb/global_control.h>

#include <optional>
#include <utility>

#include "bindings.h"
#include "boxwood/core/parallel.h"

namespace nb = nanobind;

namespace boxwood::python {

using namespace nanobind::literals;

namespace {

/// A limit that ends when it is told to, not when Python collects it.
class PyThreadLimit {
public:
    explicit PyThreadLimit(std::size_t threads) : limit_(std::in_place, threads) {}
    void end() { limit_.reset(); }

private:
    std::optional<ThreadLimit> limit_;
};

}  // namespace

void bind_threads(nb::module_& module) {
    nb::class_<PyThreadLimit>(module, "ThreadLimit")
        .def(nb::init<std::size_t>(), "threads"_a)
        .def("end", &PyThreadLimit::end);
    module.def(
        "end_threads",
        [] {
            // A process that forks has only the thread that does it, in the child; whoever waits
            // there for the others waits forever.
            tbb::task_scheduler_handle handle{tbb::attach{}};
            return tbb::finalize(handle, std::nothrow);
        },
        "Lets the worker threads end, as before fork(); they come back when there is work.");
}

}  // namespace boxwood::python
