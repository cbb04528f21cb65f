// A host of version 1.0 in C++: owners, views, exceptions and events of vblast_ss.hpp, which is compiled into the program.
#include <cinttypes>
#include <cstdio>

#include <vblast_ss/vblast_ss.hpp>

static int run()
{
    const vbss::context context;
    const vbss::scene scene = vbss::make_scene(context);
    vbss_thread_config config = vbss_thread_config_default();
    config.segment_count = 20;
    config.length = 0.04;
    const vbss::thread thread = vbss::make_thread(context, &config);
    std::uint32_t body = 0;
    scene.call(vbss_scene_add_thread, thread.get(), &body);
    for (int i = 0; i < 20; i++) {
        scene.call(vbss_scene_step, 1e-3);
    }
    const auto positions = thread.view<double>(vbss_thread_get_view, VBSS_THREAD_VIEW_POSITIONS);
    std::uint64_t hash = 0;
    scene.call(vbss_scene_get_hash, &hash);
    std::printf("owners: hash %016" PRIx64 ", %u nodes, %u events\n", hash,
                unsigned(positions.size()), unsigned(vbss::take_events(scene).size()));
    try {
        scene.call(vbss_scene_step, -1.0);
    } catch (const vbss::error &error) {
        std::printf("error: %s\n", error.what());
        return 0;
    }
    return 1;
}

int main()
{
    try {
        return run();
    } catch (const std::exception &error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
