// Owners, exceptions, views and callbacks of vblast_ss.hpp. Built as C++17 and as C++20.
#include <vblast_ss/vblast_ss.hpp>

#include <clocale>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace
{

int failures = 0;

void expect(bool holds, const char *what, int line)
{
    if (!holds) {
        std::fprintf(stderr, "line %d: %s\n", line, what);
        failures++;
    }
}
#define EXPECT(condition) expect((condition), #condition, __LINE__)

static_assert(!std::is_copy_constructible_v<vbss::scene>, "an object has one owner");
static_assert(std::is_nothrow_move_constructible_v<vbss::scene>, "and moves without a throw");

std::uint64_t objects_of(const vbss::context &context)
{
    vbss_context_statistics statistics;
    vbss::check(vbss_context_get_statistics(context, &statistics, sizeof statistics), context);
    return statistics.objects_alive;
}

void owners_move_and_destroy()
{
    const vbss::context context;
    const std::uint64_t before = objects_of(context);
    {
        vbss::scene scene = vbss::make_scene(context);
        EXPECT(objects_of(context) == before + 1);
        vbss::scene other = std::move(scene);
        EXPECT(scene.get() == nullptr && other.get() != nullptr);
        other = vbss::make_scene(context); // destroys the first
        EXPECT(objects_of(context) == before + 1);
    }
    EXPECT(objects_of(context) == before);
}

// An object keeps its context.
void object_outlives_name_of_its_context()
{
    vbss::scene scene;
    {
        const vbss::context context;
        scene = vbss::make_scene(context);
    }
    scene.call(vbss_scene_step, 1e-3);
    EXPECT(scene.read<vbss_scene_statistics>(vbss_scene_get_statistics).steps == 1);
}

void status_is_thrown_with_its_text()
{
    const vbss::context context;
    const vbss::scene scene = vbss::make_scene(context);
    bool is_caught = false;
    try {
        scene.call(vbss_scene_step, -1.0);
    } catch (const vbss::error &error) {
        const std::string text = error.what();
        is_caught = error.result() == VBSS_ERROR_OUT_OF_RANGE &&
                    text.find("VBSS_ERROR_OUT_OF_RANGE: ") == 0 &&
                    text.find('h') != std::string::npos;
    }
    EXPECT(is_caught);
}

void views_are_spans()
{
    const vbss::context context;
    vbss_thread_config config = vbss_thread_config_default();
    config.segment_count = 10;
    const vbss::thread thread = vbss::make_thread(context, &config);
    const vbss::items<double> positions =
        thread.view<double>(vbss_thread_get_view, VBSS_THREAD_VIEW_POSITIONS);
    EXPECT(positions.size() == 11);
    EXPECT(positions[10].size() == 3);
    double sum = 0.0;
    for (double x : positions[10]) {
        sum += x;
    }
    EXPECT(sum != 0.0);
    const vbss::items<double> lengths =
        thread.view<double>(vbss_thread_get_view, VBSS_THREAD_VIEW_REST_LENGTHS);
    EXPECT(lengths.values().size() == 10);
#if defined(__cpp_lib_span)
    static_assert(std::is_same_v<vbss::span<const double>, std::span<const double>>, "as in C++20");
#endif
    bool is_caught = false;
    try {
        (void)thread.view<std::uint32_t>(vbss_thread_get_view, VBSS_THREAD_VIEW_POSITIONS);
    } catch (const vbss::error &) {
        is_caught = true;
    }
    EXPECT(is_caught);
}

void events_are_taken_once()
{
    const vbss::context context;
    vbss_scene_config scene_config = vbss_scene_config_default();
    scene_config.event_capacity = 2;
    const vbss::scene scene = vbss::make_scene(context, &scene_config);
    vbss_thread_config config = vbss_thread_config_default();
    config.cut_capacity = 3;
    const vbss::thread thread = vbss::make_thread(context, &config);
    std::uint32_t body = 0, piece = 0;
    scene.call(vbss_scene_add_thread, thread.get(), &body);
    for (double share : {0.8, 0.6, 0.4}) {
        scene.call(vbss_scene_cut_thread, body, share * config.length, &piece);
    }
    std::uint64_t lost = 0;
    const std::vector<vbss_scene_event> events = vbss::take_events(scene, &lost);
    EXPECT(events.size() == 2 && lost == 1);
    EXPECT(events[0].kind == VBSS_SCENE_EVENT_CUT && events[1].body_b == piece);
    EXPECT(vbss::take_events(scene, &lost).empty() && lost == 0);
}

struct bodies {
    vbss::drain drain;
    vbss::needle needle;
    vbss::thread thread;
    vbss::grasper grasper;
    vbss::replica replica;
    vbss::record record;
};
struct bodies_end_first {
    vbss::scene scene;
    bodies all;
};
struct scene_ends_first {
    bodies all;
    vbss::scene scene;
};

// The members end in the reverse order of their declaration.
template <class Order> void fill(const vbss::context &context)
{
    Order order;
    std::uint32_t body = 0;
    const double tip[3] = {0.0, 0.3, 0.0};
    vbss_needle_config needle = vbss_needle_config_default();
    vbss_thread_config thread = vbss_thread_config_default();
    needle.position[1] = 0.1;
    thread.start[1] = 0.2;
    order.scene = vbss::make_scene(context);
    order.all.drain = vbss::make<vbss::drain>(context, vbss_drain_create, context, nullptr);
    order.all.needle = vbss::make<vbss::needle>(context, vbss_needle_create, context, &needle);
    order.all.thread = vbss::make_thread(context, &thread);
    order.all.grasper = vbss::make<vbss::grasper>(context, vbss_grasper_create, context, nullptr);
    order.all.grasper.call(vbss_grasper_set_target, tip, nullptr);
    order.scene.call(vbss_scene_add_drain, order.all.drain, &body);
    order.scene.call(vbss_scene_add_needle, order.all.needle, &body);
    order.scene.call(vbss_scene_add_thread, order.all.thread, &body);
    order.scene.call(vbss_scene_add_grasper, order.all.grasper, &body);
    order.all.replica =
        vbss::make<vbss::replica>(context, vbss_replica_create, order.scene, nullptr);
    order.all.record = vbss::make<vbss::record>(context, vbss_record_create, order.scene, nullptr);
    order.scene.call(vbss_scene_set_recorder, order.all.record);
    order.scene.call(vbss_scene_step, 1e-3);
}

void owners_end_in_any_order()
{
    int messages = 0;
    vbss::callback<void(vbss_log_level, const char *)> log([&](vbss_log_level, const char *text) {
        std::fprintf(stderr, "%s\n", text);
        messages++;
    });
    vbss_context_config config = vbss_context_config_default();
    config.log_level = VBSS_LOG_WARNING;
    config.log = log.call;
    config.log_user = &log;
    const vbss::context context(&config);
    const std::uint64_t before = objects_of(context);
    fill<bodies_end_first>(context);
    EXPECT(objects_of(context) == before);
    fill<scene_ends_first>(context);
    EXPECT(objects_of(context) == before);
    EXPECT(messages == 0);
}

// What a callback throws comes to the host after the call, and not through the library.
void exception_of_callback_waits()
{
    vbss::callback<void(vbss_log_level, const char *)> log(
        [](vbss_log_level, const char *message) { throw std::runtime_error(message); });
    vbss_context_config config = vbss_context_config_default();
    config.log_level = VBSS_LOG_ERROR;
    config.log = log.call;
    config.log_user = &log;
    const vbss::context context(&config);
    EXPECT(vbss_scene_create(context, nullptr, nullptr) == VBSS_ERROR_NULL_ARGUMENT);
    bool is_caught = false;
    try {
        log.rethrow();
    } catch (const std::runtime_error &) {
        is_caught = true;
    }
    EXPECT(is_caught);
    log.rethrow(); // once
    vbss::callback<double()> clock([]() -> double { throw std::runtime_error("no clock"); }, -1.0);
    EXPECT(clock.call(&clock) == -1.0);
}

} // namespace

int main()
{
    std::setlocale(LC_NUMERIC, "C");
    try {
        owners_move_and_destroy();
        object_outlives_name_of_its_context();
        owners_end_in_any_order();
        status_is_thrown_with_its_text();
        views_are_spans();
        events_are_taken_once();
        exception_of_callback_waits();
    } catch (const std::exception &error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return failures == 0 ? 0 : 1;
}
