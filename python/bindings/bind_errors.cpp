// SPDX-License-Identifier: Apache-2.0
#include "bindings.h"
#include "boxwood/core/error.h"

namespace nb = nanobind;

namespace boxwood::python {

void bind_errors(nb::module_& module) {
    // The last one registered is asked first.
    nb::exception<Error>(module, "Error", PyExc_RuntimeError);
    nb::register_exception_translator([](const std::exception_ptr& thrown, void*) {
        try {
            std::rethrow_exception(thrown);
        } catch (const InvalidInput& error) {
            PyErr_SetString(PyExc_ValueError, error.what());
        } catch (const IoError& error) {
            PyErr_SetString(PyExc_OSError, error.what());
        }
    });
    nb::exception<ParseError>(module, "ParseError", PyExc_ValueError);
}

}  // namespace boxwood::python
