/* The bench harness measured by a clock that the tests turn by hand. */
#include "harness/harness.h"

#include <math.h>
#include <string.h>

#include "harness/report.h"
#include "harness/run.h"
#include "harness/stats.h"

/* ---- a clock, and scenes that know how long they take */

static uint64_t fake_cpu, fake_wall;

static uint64_t read_fake_cpu(void *user)
{
    (void)user;
    return fake_cpu;
}

static uint64_t read_fake_wall(void *user)
{
    (void)user;
    return fake_wall;
}

static void spend(uint64_t cpu_ns)
{
    fake_cpu += cpu_ns;
    fake_wall += 2 * cpu_ns;
}

enum { STEPS = 4 };

typedef struct fake_scene {
    const char *name;
    uint64_t ns[BENCH_REPETITIONS][STEPS];
    unsigned repetition, setups, restores, teardowns;
    uint32_t done, beside;
    int setup_result, restore_result, failing_step; /* failing_step: -1 none */
    unsigned odd_repetition;                        /* its hash differs after step 2 */
} fake_scene;

static int setup_scene(void *user)
{
    fake_scene *scene = user;
    scene->setups++;
    return scene->setup_result;
}

static int restore_scene(void *user)
{
    fake_scene *scene = user;
    scene->repetition = scene->restores++;
    return scene->restore_result;
}

static int step_scene(void *user, uint32_t index)
{
    fake_scene *scene = user;
    spend(scene->ns[scene->repetition][index]);
    scene->done = index;
    return (int)index == scene->failing_step ? -5 : 0;
}

static uint64_t hash_scene(void *user)
{
    const fake_scene *scene = user;
    spend(1000000); /* is not the step's */
    bool odd = scene->odd_repetition != 0 && scene->repetition == scene->odd_repetition;
    return odd && scene->done == 2 ? 0 : 7u * scene->done + 1u;
}

static void finish_scene(void *user, bench_result *result)
{
    (void)user;
    bench_counter(result, "tip_error_mm", 0.25);
}

static void teardown_scene(void *user)
{
    ((fake_scene *)user)->teardowns++;
}

static fake_scene make_scene(void)
{
    fake_scene scene = {.name = "fake/scene/ours", .failing_step = -1};
    for (size_t r = 0; r < BENCH_REPETITIONS; r++) {
        for (size_t i = 0; i < STEPS; i++) {
            scene.ns[r][i] = 1000u * (i + 1) + 500u; /* 1.5, 2.5, 3.5, 4.5 us */
        }
    }
    return scene;
}

static bench_stepped stepped_case(fake_scene *scene)
{
    bench_stepped stepped = {.name = scene->name,
                             .user = scene,
                             .steps = STEPS,
                             .setup = setup_scene,
                             .restore = restore_scene,
                             .step = step_scene,
                             .hash = hash_scene,
                             .finish = finish_scene,
                             .teardown = teardown_scene};
    return stepped;
}

/* A kernel of n items in ns_per_item * n^power. */
typedef struct fake_kernel {
    const char *name;
    uint32_t n;
    double ns, power;
} fake_kernel;

static void run_kernel(void *user)
{
    const fake_kernel *kernel = user;
    spend((uint64_t)(kernel->ns * pow((double)kernel->n, kernel->power) + 0.5));
}

static void add_kernel(bench *b, fake_kernel *kernel)
{
    const bench_batch batch = {
        .name = kernel->name, .user = kernel, .items = kernel->n, .run = run_kernel};
    bench_add_batch(b, &batch);
}

/* A run of what `add` registers; end it with bench_end. */
static void run_suite(bench *b, void (*add)(bench *b), const char *filter)
{
    static bench_suite suite;
    suite = (bench_suite){"fake", "fake library", add};
    bench_options options = bench_default_options();
    options.filter = filter;
    const bench_clock clock = {read_fake_cpu, read_fake_wall, NULL};
    assert_true(bench_begin(b, &suite, &options, &clock));
    bench_run_cases(b, NULL);
}

static bench_result measure(const bench_stepped *stepped)
{
    bench b = {.options = bench_default_options(), .clock = {read_fake_cpu, read_fake_wall, NULL}};
    bench_result result = {0};
    bench_measure_stepped(&b, stepped, &result);
    return result;
}

/* ---- statistics */

static void percentiles_are_nearest_rank(void **state)
{
    (void)state;
    double values[1000];
    for (size_t i = 0; i < 1000; i++) {
        values[i] = (double)(1000 - i);
    }
    bench_sort(values, 1000);
    expect_same_bits(1.0, bench_percentile(values, 1000, 0));
    expect_same_bits(500.0, bench_percentile(values, 1000, 500));
    expect_same_bits(990.0, bench_percentile(values, 1000, 990));
    expect_same_bits(999.0, bench_percentile(values, 1000, 999));
    expect_same_bits(1000.0, bench_percentile(values, 1000, 1000));
    /* Between ranks the next higher one; an even number has its lower middle as median. */
    expect_same_bits(999.0, bench_percentile(values, 999, 1000));
    expect_same_bits(990.0, bench_percentile(values, 999, 990));
    expect_same_bits(10.0, bench_percentile(values, 10, 901));
    expect_same_bits(5.0, bench_percentile(values, 10, 500));
    expect_same_bits(4.0, bench_percentile(values, 7, 500));
    expect_same_bits(1.0, bench_percentile(values, 1, 500));
    assert_true(isnan(bench_percentile(values, 0, 500)));
}

static void power_law_fit_recovers_exponent(void **state)
{
    (void)state;
    const double x[] = {30.0, 60.0, 120.0, 240.0, 10000.0};
    double y[5];
    for (size_t i = 0; i < 5; i++) {
        y[i] = 3.5 * pow(x[i], 1.25);
    }
    bench_power_fit fit;
    assert_true(bench_fit_power(x, y, 5, &fit));
    expect_near(1.25, fit.exponent, 1e-12);
    expect_near(3.5, fit.scale, 1e-10);
    expect_near(1.0, fit.r2, 1e-12);

    const double crooked[] = {1.0, 8.0, 4.0, 32.0, 7.0};
    assert_true(bench_fit_power(x, crooked, 5, &fit));
    assert_true(fit.r2 < 0.9);
    const double flat[] = {2.0, 2.0, 2.0, 2.0, 2.0};
    assert_true(bench_fit_power(x, flat, 5, &fit));
    expect_near(0.0, fit.exponent, 1e-12);
    expect_near(1.0, fit.r2, 1e-12);

    assert_false(bench_fit_power(flat, x, 5, &fit)); /* no two x */
    assert_false(bench_fit_power(x, y, 1, &fit));
    assert_false(bench_fit_power(x, y, 0, &fit));
    y[3] = 0.0;
    assert_false(bench_fit_power(x, y, 5, &fit));
    y[3] = (double)NAN;
    assert_false(bench_fit_power(x, y, 5, &fit));
}

/* ---- stepped cases */

static void minimum_over_repetitions_is_taken(void **state)
{
    (void)state;
    fake_scene scene = make_scene();
    /* Every repetition is disturbed somewhere, each step is left alone at least once. */
    for (size_t r = 0; r < BENCH_REPETITIONS; r++) {
        scene.ns[r][r % STEPS] += 90000u;
    }
    scene.ns[6][3] -= 500u;
    bench_stepped stepped = stepped_case(&scene);
    stepped.deadline_us = 2.5; /* steps above it: those of 3.5 and 4 us */
    stepped.dt_us = 500.0;
    bench_result result = measure(&stepped);
    assert_false(result.failed);
    assert_int_equal(result.repetitions, BENCH_REPETITIONS);
    assert_int_equal(result.iterations, STEPS);
    assert_string_equal(result.time_unit, "us");
    expect_near(2.5, result.cpu_time, 1e-12);
    expect_near(5.0, result.real_time, 1e-12);
    expect_near(2.5, bench_counter_value(&result, "median_us"), 1e-12);
    expect_near(4.0, bench_counter_value(&result, "p99_us"), 1e-12);
    expect_near(4.0, bench_counter_value(&result, "p999_us"), 1e-12);
    expect_near(4.0, bench_counter_value(&result, "max_us"), 1e-12);
    expect_near(8.0, bench_counter_value(&result, "wall_max_us"), 1e-12);
    expect_near(2.0, bench_counter_value(&result, "steps_over_deadline"), 0.0);
    /* 11.5 us in 2 simulated ms */
    expect_near(5.75, bench_counter_value(&result, "us_per_ms"), 1e-12);
    expect_near(0.25, bench_counter_value(&result, "tip_error_mm"), 0.0);
    assert_int_equal(scene.setups, 1);
    assert_int_equal(scene.restores, BENCH_REPETITIONS);
    assert_int_equal(scene.teardowns, 1);
}

static int spend_beside(void *user, uint32_t index)
{
    fake_scene *scene = user;
    (void)index;
    spend(700000); /* neither is the step's */
    scene->beside++;
    return 0;
}

static int refuse_step(void *user, uint32_t index)
{
    (void)user;
    return index == 2 ? -6 : 0;
}

static void work_outside_step_is_not_timed(void **state)
{
    (void)state;
    fake_scene scene = make_scene();
    bench_stepped stepped = stepped_case(&scene);
    stepped.before = stepped.after = spend_beside;
    bench_result result = measure(&stepped);
    assert_false(result.failed);
    assert_int_equal(scene.beside, 2 * STEPS * BENCH_REPETITIONS);
    expect_near(4.5, bench_counter_value(&result, "max_us"), 1e-12);
    expect_near(9.0, bench_counter_value(&result, "wall_max_us"), 1e-12);
    /* It ends the case as the step itself would. */
    scene = make_scene();
    stepped.before = refuse_step;
    assert_non_null(strstr(measure(&stepped).error, "step 2 returned -6"));
    assert_int_equal(scene.done, 1);
    scene = make_scene();
    stepped.before = NULL;
    stepped.after = refuse_step;
    assert_non_null(strstr(measure(&stepped).error, "step 2 returned -6"));
    assert_int_equal(scene.done, 2);
}

/* A clock that costs 300 ns a reading, inside one that costs 20. */
static uint64_t read_dear_cpu(void *user)
{
    (void)user;
    fake_wall += 300;
    return fake_cpu += 300;
}

static uint64_t read_dear_wall(void *user)
{
    (void)user;
    return fake_wall += 20;
}

static void clock_overhead_is_subtracted(void **state)
{
    (void)state;
    const bench_clock clock = {read_dear_cpu, read_dear_wall, NULL};
    fake_scene scene = make_scene();
    bench_stepped stepped = stepped_case(&scene);
    bench b = {.options = bench_default_options(), .clock = clock};
    bench_result result = {0};
    b.timer = bench_measure_timer(&clock);
    expect_near(300.0, b.timer.overhead_ns, 1e-9);
    expect_near(300.0, b.timer.resolution_ns, 1e-9);
    assert_int_equal(b.timer.empty_cpu_ns, 300);
    assert_int_equal(b.timer.empty_wall_ns, 620);
    bench_measure_stepped(&b, &stepped, &result);
    expect_near(2.5, result.cpu_time, 1e-12);
    expect_near(5.0, result.real_time, 1e-12);
    /* Never below zero. */
    const bench_interval less = bench_interval_net((bench_interval){299, 1}, b.timer);
    assert_int_equal(less.cpu_ns, 0);
    assert_int_equal(less.wall_ns, 0);
}

static void diverging_repetition_is_an_error(void **state)
{
    (void)state;
    fake_scene scene = make_scene();
    scene.odd_repetition = 5;
    bench_stepped stepped = stepped_case(&scene);
    bench_result result = measure(&stepped);
    assert_true(result.failed);
    assert_non_null(strstr(result.error, "repetition 5"));
    assert_non_null(strstr(result.error, "step 2"));
    assert_null(result.time_unit);
    assert_int_equal(scene.teardowns, 1);
    /* Without a hash nobody can tell. */
    scene = make_scene();
    scene.odd_repetition = 5;
    stepped.hash = NULL;
    result = measure(&stepped);
    assert_false(result.failed);
}

static void failing_callback_ends_case(void **state)
{
    (void)state;
    fake_scene scene = make_scene();
    bench_stepped stepped = stepped_case(&scene);
    scene.setup_result = -1;
    assert_non_null(strstr(measure(&stepped).error, "setup returned -1"));
    assert_int_equal(scene.restores, 0);
    assert_int_equal(scene.teardowns, 0);

    scene = make_scene();
    scene.restore_result = -2;
    assert_non_null(strstr(measure(&stepped).error, "restore returned -2"));
    assert_int_equal(scene.teardowns, 1);

    scene = make_scene();
    scene.failing_step = 1;
    assert_non_null(strstr(measure(&stepped).error, "step 1 returned -5"));
    assert_int_equal(scene.restores, 1);
    assert_int_equal(scene.teardowns, 1);
}

/* ---- batches and growth */

static fake_kernel kernels[] = {
    {"fake/square/ours/10", 10, 2.0, 2.0},     {"fake/square/ours/100", 100, 2.0, 2.0},
    {"fake/square/ours/1000", 1000, 2.0, 2.0}, {"fake/square/paper/10", 10, 6.0, 2.0},
    {"fake/square/ours/2000", 2000, 2.0, 3.0}, {"fake/plain/ours", 50, 3.0, 1.0},
};

static void add_kernels(bench *b)
{
    /* Before its family: it is fitted last all the same. */
    bench_add_growth(b, &(bench_growth){"fake/square/ours", "fake/square/ours", 0, 1000});
    for (size_t i = 0; i < sizeof kernels / sizeof kernels[0]; i++) {
        add_kernel(b, &kernels[i]);
    }
    bench_add_growth(b, &(bench_growth){"fake/square/paper", "fake/square/paper", 0, 0});
    bench_add_skipped(b, "fake/plain/peer", "not installed");
}

static const bench_case *find_case(const bench *b, const char *name)
{
    for (size_t i = 0; i < b->count; i++) {
        if (strcmp(b->cases[i].name, name) == 0) {
            return &b->cases[i];
        }
    }
    fail_msg("no case %s", name);
    return NULL;
}

static void batch_is_timed_per_item(void **state)
{
    (void)state;
    bench b;
    run_suite(&b, add_kernels, "fake/plain");
    const bench_result *result = &find_case(&b, "fake/plain/ours")->result;
    assert_false(result->failed);
    assert_string_equal(result->time_unit, "ns");
    expect_near(3.0, result->cpu_time, 1e-12);
    expect_near(6.0, result->real_time, 1e-12);
    expect_near(3.0, bench_counter_value(result, "ns"), 1e-12);
    expect_near(3.0, bench_counter_value(result, "median_ns"), 1e-12);
    /* One call takes 150 ns; enough of them for the least time of a batch. */
    assert_true((double)result->iterations * 3.0 >= b.options.batch_ns);
    bench_end(&b);
}

static void run_trial(void *user, bench_result *result)
{
    double cpu[3] = {5.0, 1.0, 3.0}, wall[3] = {2.0, 7.0, 6.0};
    uint32_t *runs = user;
    ++*runs;
    bench_trial_steps(result, cpu, wall, *runs == 1 ? 3 : 0);
    bench_counter(result, "completed", 0.5);
}

static void trial_runs_once_and_times_itself(void **state)
{
    (void)state;
    uint32_t runs = 0;
    const bench_trial trial = {"fake/trial/ours", &runs, run_trial};
    bench_result result = {0}, second = {0};
    bench_measure_trial(&trial, &result);
    assert_false(result.failed);
    assert_int_equal(runs, 1);
    assert_int_equal(result.repetitions, 1);
    assert_int_equal(result.iterations, 3);
    expect_same_bits(3.0, result.cpu_time);
    expect_same_bits(6.0, result.real_time);
    expect_same_bits(5.0, bench_counter_value(&result, "max_us"));
    expect_same_bits(3.0, bench_counter_value(&result, "mean_us"));
    expect_same_bits(0.5, bench_counter_value(&result, "completed"));
    bench_measure_trial(&trial, &second); /* this time it makes no step */
    assert_true(second.failed);
}

static void expensive_timer_enlarges_batch(void **state)
{
    (void)state;
    fake_kernel kernel = {"fake/plain/ours", 50, 3.0, 1.0};
    const bench_batch batch = {
        .name = kernel.name, .user = &kernel, .items = kernel.n, .run = run_kernel};
    bench b = {.options = bench_default_options(),
               .clock = {read_fake_cpu, read_fake_wall, NULL},
               .timer = {.overhead_ns = 1000.0, .resolution_ns = 50000.0}};
    bench_result result = {0};
    bench_measure_batch(&b, &batch, &result);
    assert_false(result.failed);
    assert_true((double)result.iterations * 3.0 >= 200.0 * 50000.0);
}

static void growth_fit_uses_its_range(void **state)
{
    (void)state;
    bench b;
    run_suite(&b, add_kernels, NULL);
    const bench_case *growth = find_case(&b, "fake/square/ours");
    assert_true(growth->measured);
    assert_false(growth->result.failed);
    /* Time of a whole call, not per item; N = 2000 is outside the range and does not fit in. */
    expect_near(2.0, bench_counter_value(&growth->result, "exponent"), 1e-9);
    expect_near(3.0, bench_counter_value(&growth->result, "points"), 0.0);
    expect_near(1000.0, bench_counter_value(&growth->result, "n_max"), 0.0);
    expect_near(2000.0, growth->result.cpu_time, 1e-6);
    /* One point is no family: an error, and the only one. */
    assert_true(find_case(&b, "fake/square/paper")->result.failed);
    assert_int_equal(bench_failures(&b), 1);
    bench_end(&b);
}

/* ---- pools */

static fake_scene pooled_scenes[2], lone_scene;

static void finish_pool(void *user, bench_result *result)
{
    (void)user;
    bench_counter(result, "through", 1.0);
}

static void add_pooled(bench *b)
{
    /* Before its cases: it is made last all the same. */
    bench_add_pool(b, &(bench_pool){.name = "fake/scene/all",
                                    .dt_us = 500.0,
                                    .deadline_us = 13.0,
                                    .finish = finish_pool});
    for (size_t i = 0; i < 2; i++) {
        bench_stepped stepped = stepped_case(&pooled_scenes[i]);
        stepped.pool = "fake/scene/all";
        bench_add_stepped(b, &stepped);
    }
    bench_stepped lone = stepped_case(&lone_scene);
    bench_add_stepped(b, &lone);
    bench_add_pool(b, &(bench_pool){.name = "fake/nobody/all"});
}

static void make_pooled_scenes(void)
{
    pooled_scenes[0] = pooled_scenes[1] = lone_scene = make_scene();
    pooled_scenes[0].name = "fake/scene/first";
    pooled_scenes[1].name = "fake/scene/second";
    for (size_t r = 0; r < BENCH_REPETITIONS; r++) {
        for (size_t i = 0; i < STEPS; i++) {
            pooled_scenes[1].ns[r][i] += 10000u + (r == i ? 0u : 5000u);
            lone_scene.ns[r][i] += 1000000u;
        }
    }
}

static void pool_takes_minimum_of_each_step(void **state)
{
    (void)state;
    bench b;
    make_pooled_scenes();
    run_suite(&b, add_pooled, "fake/scene");
    const bench_result *result = &find_case(&b, "fake/scene/all")->result;
    assert_int_equal(bench_failures(&b), 0);
    assert_int_equal(result->repetitions, BENCH_REPETITIONS);
    assert_int_equal(result->iterations, 2 * STEPS);
    assert_string_equal(result->time_unit, "us");
    /* 1.5 to 4.5 us, and 11.5 to 14.5 */
    expect_near(4.5, bench_counter_value(result, "median_us"), 1e-12);
    expect_near(9.0, bench_counter_value(result, "wall_median_us"), 1e-12);
    expect_near(14.5, bench_counter_value(result, "p999_us"), 1e-12);
    expect_near(8.0, bench_counter_value(result, "mean_us"), 1e-12);
    expect_near(16.0, bench_counter_value(result, "us_per_ms"), 1e-12);
    expect_near(2.0, bench_counter_value(result, "steps_over_deadline"), 0.0);
    expect_near(1.0, bench_counter_value(result, "through"), 0.0);
    bench_end(&b);
}

static void pool_fails_with_its_cases(void **state)
{
    (void)state;
    bench b;
    make_pooled_scenes();
    pooled_scenes[1].failing_step = 1;
    run_suite(&b, add_pooled, NULL);
    const bench_result *result = &find_case(&b, "fake/scene/all")->result;
    assert_non_null(strstr(result->error, "fake/scene/second failed"));
    assert_null(result->time_unit);
    /* One without cases too, unless a filter left them out. */
    assert_non_null(strstr(find_case(&b, "fake/nobody/all")->result.error, "no case"));
    assert_int_equal(bench_failures(&b), 3);
    bench_end(&b);
    run_suite(&b, add_pooled, "all");
    assert_false(find_case(&b, "fake/scene/all")->measured);
    assert_int_equal(bench_failures(&b), 0);
    bench_end(&b);
}

/* ---- choosing and naming */

static void filter_matches_substring(void **state)
{
    (void)state;
    bench b;
    run_suite(&b, add_kernels, "square/ours/1");
    assert_int_equal(bench_selected(&b), 3);
    for (size_t i = 0; i < b.count; i++) {
        bool wanted = strstr(b.cases[i].name, "square/ours/1") != NULL;
        assert_int_equal(b.cases[i].measured, wanted);
    }
    bench_end(&b);
    /* A growth whose family was filtered away is not judged. */
    run_suite(&b, add_kernels, "square/paper");
    assert_false(find_case(&b, "fake/square/paper")->measured);
    assert_int_equal(bench_failures(&b), 0);
    bench_end(&b);
}

static fake_kernel odd_kernel;
static void add_odd_kernel(bench *b)
{
    add_kernel(b, &kernels[0]);
    add_kernel(b, &odd_kernel);
}

static void case_names_are_checked(void **state)
{
    (void)state;
    static const char *const bad[] = {"fake/scene",          "other/scene/ours", "fake//ours",
                                      "fake/scene/ours/1/2", "fake/scene/",      "fakes/scene/ours",
                                      "fake/square/ours/10"};
    const bench_suite suite = {"fake", "", add_odd_kernel};
    const bench_options options = bench_default_options();
    const bench_clock clock = bench_system_clock();
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        bench b;
        odd_kernel = (fake_kernel){bad[i], 1, 1.0, 1.0};
        assert_false(bench_begin(&b, &suite, &options, &clock));
        assert_non_null(strstr(b.error, bad[i]));
        bench_end(&b);
    }
    bench_name parts;
    assert_true(bench_split_name("thread", "thread/cantilever/ours/120", &parts));
    assert_string_equal(parts.scene, "cantilever");
    assert_string_equal(parts.method, "ours");
    assert_string_equal(parts.n, "120");
}

static bool parse(bench_options *options, const char *first, const char *second, const char *third)
{
    char words[4][32] = {"bench_fake", "", "", ""};
    char *argv[] = {words[0], words[1], words[2], words[3], NULL};
    const char *const given[] = {first, second, third};
    int argc = 1;
    while (argc < 4 && given[argc - 1] != NULL) {
        snprintf(words[argc], sizeof words[argc], "%s", given[argc - 1]);
        argc++;
    }
    FILE *complaints = tmpfile();
    assert_non_null(complaints);
    bool good = bench_parse_options(argc, argv, options, complaints);
    assert_int_equal(ftell(complaints) > 0, !good);
    fclose(complaints);
    return good;
}

static void options_are_parsed(void **state)
{
    (void)state;
    bench_options options;
    assert_true(parse(&options, NULL, NULL, NULL));
    assert_int_equal(options.repetitions, 7);
    assert_false(options.quick);
    assert_true(parse(&options, "--quick", NULL, NULL));
    assert_int_equal(options.repetitions, 2);
    assert_true(options.quick);
    assert_true(parse(&options, "--repetitions", "20", NULL));
    assert_int_equal(options.repetitions, 20);
    assert_true(parse(&options, "--repetitions", "3", "--quick"));
    assert_int_equal(options.repetitions, 3);
    assert_int_equal(options.seeds, BENCH_QUICK_SEEDS);
    assert_true(parse(&options, "--seeds", "100", NULL));
    assert_int_equal(options.seeds, 100);
    assert_int_equal(options.repetitions, 7);
    assert_false(parse(&options, "--seeds", "0", NULL));
    assert_false(parse(&options, "--repetitions", "6", NULL));
    assert_false(parse(&options, "--repetitions", "7x", NULL));
    assert_false(parse(&options, "--repetitions", "-8", NULL));
    assert_false(parse(&options, "--quick", "--repetitions", "1"));
    assert_false(parse(&options, "--out", NULL, NULL));
    assert_false(parse(&options, "--fast", NULL, NULL));
    assert_false(parse(&options, "square", NULL, NULL));
}

static void counters_are_kept_and_checked(void **state)
{
    (void)state;
    bench_result result = {0};
    bench_counter(&result, "a", 1.0);
    bench_counter(&result, "b", 2.0);
    bench_counter(&result, "a", 3.0);
    assert_int_equal(result.counter_count, 2);
    expect_same_bits(3.0, bench_counter_value(&result, "a"));
    assert_true(isnan(bench_counter_value(&result, "c")));
    assert_false(result.failed);
    bench_counter(&result, "real_time", 1.0); /* a key of the schema */
    assert_true(result.failed);
    assert_int_equal(result.counter_count, 2);

    bench_result full = {0};
    for (int i = 0; i < BENCH_MAX_COUNTERS; i++) {
        char name[16];
        snprintf(name, sizeof name, "c%d", i);
        bench_counter(&full, name, 1.0);
    }
    assert_false(full.failed);
    bench_counter(&full, "one_more", 1.0);
    assert_true(full.failed);
}

/* ---- the table */

static void table_sets_methods_side_by_side(void **state)
{
    (void)state;
    bench b;
    bench_environment environment = {.date = "today", .compiler = "cc", .flags = "-O3"};
    run_suite(&b, add_kernels, NULL);
    FILE *file = tmpfile();
    assert_non_null(file);
    bench_print_table(&b, &environment, file);
    bench_end(&b);
    rewind(file);
    char line[512], before[512] = "", scene[64], method[64], ratio[64];
    unsigned n = 0, found = 0;
    while (fgets(line, sizeof line, file) != NULL) {
        size_t length = strlen(line);
        assert_true(length < 2 || line[length - 2] != ' ');
        if (sscanf(line, "%63s %u %63s", method, &n, ratio) == 3 && n == 10 &&
            strcmp(method, "paper") == 0) {
            assert_string_equal(ratio, "3.00");
            assert_int_equal(sscanf(before, "%63s %63s %u %63s", scene, method, &n, ratio), 4);
            assert_string_equal(scene, "square");
            assert_string_equal(method, "ours");
            assert_int_equal(n, 10);
            assert_string_equal(ratio, "1.00");
            found++;
        }
        found += strstr(line, "fake/square/ours: time grows as N^2.000 from 10 to 1000") != NULL;
        found += strstr(line, "skipped fake/plain/peer: not installed") != NULL;
        found += strstr(line, "ERROR fake/square/paper: only 1 cases") != NULL;
        memcpy(before, line, sizeof before);
    }
    assert_int_equal(found, 4);
    fclose(file);
}

int test_bench_harness(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(percentiles_are_nearest_rank),
        cmocka_unit_test(power_law_fit_recovers_exponent),
        cmocka_unit_test(minimum_over_repetitions_is_taken),
        cmocka_unit_test(work_outside_step_is_not_timed),
        cmocka_unit_test(clock_overhead_is_subtracted),
        cmocka_unit_test(diverging_repetition_is_an_error),
        cmocka_unit_test(failing_callback_ends_case),
        cmocka_unit_test(batch_is_timed_per_item),
        cmocka_unit_test(trial_runs_once_and_times_itself),
        cmocka_unit_test(expensive_timer_enlarges_batch),
        cmocka_unit_test(growth_fit_uses_its_range),
        cmocka_unit_test(pool_takes_minimum_of_each_step),
        cmocka_unit_test(pool_fails_with_its_cases),
        cmocka_unit_test(filter_matches_substring),
        cmocka_unit_test(case_names_are_checked),
        cmocka_unit_test(options_are_parsed),
        cmocka_unit_test(counters_are_kept_and_checked),
        cmocka_unit_test(table_sets_methods_side_by_side),
    };
    return cmocka_run_group_tests_name("bench.harness", tests, NULL, NULL);
}
