// SPDX-License-Identifier: Apache-2.0
#include "bindings.h"

NB_MODULE(_core, module) {
    module.doc() = "The compiled part of boxwood; boxwood itself is what to use.";
    boxwood::python::bind_errors(module);
    boxwood::python::bind_meshes(module);
    boxwood::python::bind_trees(module);
    boxwood::python::bind_scenes(module);
    boxwood::python::bind_pictures(module);
    boxwood::python::bind_threads(module);
}
