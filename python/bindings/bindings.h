// SPDX-License-Identifier: Apache-2.0
// What the module boxwood._core is put together from. It takes arrays of the right kind and shape
// and writes into others; the package around it, python/boxwood, sees to that and talks to the
// user.
#pragma once

#include <nanobind/nanobind.h>

namespace boxwood::python {

void bind_errors(nanobind::module_& module);
void bind_meshes(nanobind::module_& module);
void bind_trees(nanobind::module_& module);
void bind_scenes(nanobind::module_& module);
void bind_pictures(nanobind::module_& module);
void bind_threads(nanobind::module_& module);

}  // namespace boxwood::python
