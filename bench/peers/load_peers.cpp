// SPDX-License-Identifier: Apache-2.0
#include "peers/load_peers.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "boxwood/core/error.h"
#include "peers/boxwood.h"

namespace boxwood::bench {

namespace {

void load(const std::filesystem::path& module, Peers& peers) {
    // Deep binding: a peer that brings its own TBB uses that one. Never closed: its code is in use
    // until the end.
    void* handle = dlopen(module.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_DEEPBIND);
    if (!handle) throw Error(fmt::format("{}: {}", module.string(), dlerror()));
    void* symbol = dlsym(handle, "boxwood_bench_add_peers");
    if (!symbol) throw Error(fmt::format("{}: {}", module.string(), dlerror()));
    reinterpret_cast<decltype(&boxwood_bench_add_peers)>(symbol)(peers);
}

}  // namespace

Peers load_peers(const std::vector<std::string>& libraries) {
    std::vector<std::filesystem::path> modules;
    if (std::filesystem::is_directory(BOXWOOD_BENCH_MODULES))
        for (const auto& entry : std::filesystem::directory_iterator(BOXWOOD_BENCH_MODULES))
            if (entry.path().extension() == ".so") modules.push_back(entry.path());
    std::sort(modules.begin(), modules.end());

    for (const std::string& library : libraries) {
        const bool found = library == "boxwood" ||
                           std::any_of(modules.begin(), modules.end(),
                                       [&](const auto& path) { return path.stem() == library; });
        if (!found) throw Error(fmt::format("no peer '{}' here; ./dev setup peers", library));
    }
    Peers peers;
    peers.push_back(make_boxwood());
    for (const auto& module : modules) {
        const bool wanted = libraries.empty() || std::find(libraries.begin(), libraries.end(),
                                                           module.stem()) != libraries.end();
        if (wanted) load(module, peers);
    }
    return peers;
}

}  // namespace boxwood::bench
