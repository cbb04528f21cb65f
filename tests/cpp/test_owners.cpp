// Owners, exceptions, views and callbacks of vblast_ss.hpp. Built as C++17 and as C++20.
#include <vblast_ss/vblast_ss.hpp>

#include <clocale>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

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
    order.all.drain = context.make(vbss_drain_create, nullptr);
    order.all.needle = context.make(vbss_needle_create, &needle);
    order.all.thread = vbss::make_thread(context, &thread);
    order.all.grasper = context.make(vbss_grasper_create, nullptr);
    order.all.grasper.call(vbss_grasper_set_target, tip, nullptr);
    order.scene.call(vbss_scene_add_drain, order.all.drain, &body);
    order.scene.call(vbss_scene_add_needle, order.all.needle, &body);
    order.scene.call(vbss_scene_add_thread, order.all.thread, &body);
    order.scene.call(vbss_scene_add_grasper, order.all.grasper, &body);
    order.all.replica = order.scene.make(vbss_replica_create, nullptr);
    order.all.record = order.scene.make(vbss_record_create, nullptr);
    order.scene.call(vbss_scene_set_recorder, order.all.record);
    order.scene.call(vbss_scene_step, 1e-3);
}

void owners_end_in_any_order()
{
    int messages = 0;
    const vbss::context context([&](vbss_log_level, const char *text) {
        std::fprintf(stderr, "%s\n", text);
        messages++;
    });
    const std::uint64_t before = objects_of(context);
    fill<bodies_end_first>(context);
    EXPECT(objects_of(context) == before);
    fill<scene_ends_first>(context);
    EXPECT(objects_of(context) == before);
    EXPECT(messages == 0);
}

void messages_reach_function_of_context()
{
    std::string heard;
    vbss::scene scene;
    {
        const vbss::context context(
            [&](vbss_log_level, const char *text) {
                heard = text;
                throw std::runtime_error("lost");
            },
            VBSS_LOG_ERROR);
        scene = vbss::make_scene(context);
    }
    EXPECT(vbss_scene_step(scene, -1.0) == VBSS_ERROR_OUT_OF_RANGE); // the context is alive
    EXPECT(heard.find('h') != std::string::npos);
}

// A scene goes through its log and through its saved bytes into scenes with the same hash.
void recorded_scene_comes_back()
{
    const vbss::context context;
    EXPECT(vbss::measure_core_speed(context) > 0.0);
    const vbss::scene scene = vbss::make_scene(context);
    const vbss::thread thread = vbss::make_thread(context);
    EXPECT(scene.value(vbss_scene_add_thread, thread) == 1);
    const vbss::replica replica = scene.make(vbss_replica_create, nullptr);
    EXPECT(vbss::take_state(replica).is_new == 0);
    const vbss::record record = scene.make(vbss_record_create, nullptr);
    std::vector<std::uint8_t> log;
    scene.call(vbss_scene_set_recorder, record);
    for (int i = 0; i < 3; i++) {
        scene.call(vbss_scene_step, 1e-3);
        const auto bytes = vbss::take_bytes(record);
        log.insert(log.end(), bytes.begin(), bytes.end());
    }
    replica.call(vbss_replica_publish, scene);
    EXPECT(vbss::take_state(replica).steps == 3);
    record.call(vbss_record_end);
    const auto end = vbss::take_bytes(record);
    log.insert(log.end(), end.begin(), end.end());
    const std::uint64_t hash = scene.value(vbss_scene_get_hash);

    const vbss::context other;
    const vbss::replay replay = other.make(vbss_replay_create, log.data(), log.size());
    const vbss::scene replayed = replay.make(vbss_replay_load_scene);
    EXPECT(vbss::replay_to_end(replay).outcome == VBSS_REPLAY_OUTCOME_ENDED);
    EXPECT(replayed.value(vbss_scene_get_hash) == hash);
    const std::vector<std::uint8_t> saved = scene.save(vbss_scene_save);
    const vbss::scene loaded = other.make(vbss_scene_load, saved.data(), saved.size());
    EXPECT(loaded.value(vbss_scene_get_hash) == hash);
}

class pen : public vbss::adapter
{
  public:
    bool is_plugged = true;
    double force = 0.0;

  private:
    void read(double now, vbss_device_sample &sample) override
    {
        if (!is_plugged) {
            throw std::runtime_error("the pen is unplugged");
        }
        sample.position[0] = 0.01;
        sample.valid = VBSS_DEVICE_HAS_POSITION;
        sample.time = now;
    }
    void write(double, const vbss_output_result &output) override
    {
        force = output.force[0];
    }
};

// The functions of an adapter are called, and what they throw becomes a status with a text.
void adapter_throws_no_further_than_its_device()
{
    const vbss::context context;
    pen hardware;
    const vbss_device_adapter table = hardware.table("pen");
    const vbss::device device = context.make(vbss_device_create, &table, nullptr, nullptr);
    vbss_output_command command = vbss_output_command_default();
    command.force[0] = 0.5;
    for (int i = 1; i <= 50; i++) {
        EXPECT(device.read<vbss_device_input>(vbss_device_read, 1e-3 * i).position[0] == 0.01);
        device.call(vbss_device_write, 1e-3 * i, &command, nullptr, 0u);
    }
    EXPECT(hardware.force == 0.5);
    hardware.is_plugged = false;
    const auto input = device.read<vbss_device_input>(vbss_device_read, 0.051);
    EXPECT(input.status == VBSS_DEVICE_STATUS_LOST);
    EXPECT(hardware.force == 0.0);
    vbss_result result = VBSS_OK;
    const char *text = nullptr;
    device.call(vbss_device_get_error, 0u, &result, &text);
    EXPECT(result == VBSS_ERROR_DEVICE && std::string(text).find("unplugged") != std::string::npos);
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
        messages_reach_function_of_context();
        recorded_scene_comes_back();
        adapter_throws_no_further_than_its_device();
        exception_of_callback_waits();
    } catch (const std::exception &error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return failures == 0 ? 0 : 1;
}
