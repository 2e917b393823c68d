// SPDX-License-Identifier: Apache-2.0
#include <tbb/global_control.h>

#include <optional>
#include <utility>

#include "bindings.h"
#include "boxwood/core/parallel.h"
#include "unlocked.h"

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
        "before_fork",
        [] {
            const nb::gil_scoped_release unlocked;
            ForkGate::before_fork();
            tbb::task_scheduler_handle handle{tbb::attach{}};
            // Threads of Python that have asked and live on keep the workers alive, who are about
            // to fall asleep then.
            if (!tbb::finalize(handle, std::nothrow))
                for (int i = 0; i < 5; ++i) ForkGate::pause();
        },
        "Waits until the work of other threads is done and lets the workers end; they come back "
        "when there is work.");
    module.def("after_fork_in_parent", &ForkGate::after_fork_in_parent);
    module.def("after_fork_in_child", &ForkGate::after_fork_in_child);
}

}  // namespace boxwood::python
