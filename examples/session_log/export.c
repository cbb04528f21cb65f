/* Prints what a log says; no scene is needed. Numbers are printed so that they read back to the same bits. */
#include "session_log/export.h"

#include <inttypes.h>
#include <stdbool.h>

#define TRY(call)                     \
    do {                              \
        vbss_result result_ = (call); \
        if (result_ != VBSS_OK) {     \
            return result_;           \
        }                             \
    } while (0)

/* ---- for people */

static vbss_result check(vbss_context *context, const log_file *log, vbss_record_log_report *report)
{
    return vbss_record_check_log(context, log->bytes, log->count, report, sizeof *report);
}

vbss_result print_info(FILE *out, vbss_context *context, const log_file *log)
{
    vbss_record_log_report report;
    vbss_replay_info info;
    vbss_replay *replay;
    TRY(check(context, log, &report));
    TRY(vbss_replay_create(context, log->bytes, log->count, &replay));
    TRY(vbss_replay_get_info(replay, &info, sizeof info));
    fprintf(out, "written by %s\n", info.build_info);
    fprintf(out, "hash every %" PRIu32 " steps, note of %" PRIu32 " bytes\n", info.hash_interval,
            info.note_bytes);
    fprintf(out,
            "%" PRIu64 " steps, %.6g s, %.6g s of it lost, %" PRIu64 " inputs, %" PRIu64
            " events\n",
            report.steps, report.time, report.time_lost, report.inputs, report.events);
    fprintf(out, "%" PRIu64 " snapshots, the first of %" PRIu64 " bytes\n", report.snapshots,
            info.snapshot_bytes);
    fprintf(out, "%" PRIu64 " bytes, of which %" PRIu64 " are good: %s\n", report.log_bytes,
            report.good_bytes, vbss_result_name(report.result));
    TRY(vbss_replay_destroy(replay));
    return report.result;
}

vbss_result print_faults(FILE *out, vbss_context *context, const log_file *log)
{
    vbss_record_log_report report;
    TRY(check(context, log, &report));
    for (uint32_t i = 0; i < report.fault_count && i < 8; i++) {
        fprintf(out, "byte %" PRIu64 ": %s (%s)\n", report.fault_positions[i],
                report.fault_problems[i], vbss_result_name(report.fault_results[i]));
    }
    fprintf(out, "%" PRIu32 " faults; %" PRIu64 " steps in %" PRIu64 " of %" PRIu64 " bytes\n",
            report.fault_count, report.steps, report.good_bytes, report.log_bytes);
    return report.result;
}

/* ---- for programs */

typedef void (*step_printer)(FILE *out, const vbss_replay_logged_step *step);

/* The end is a status as well, which is no failure. */
static vbss_result print_steps(FILE *out, vbss_replay *replay, step_printer print)
{
    vbss_replay_logged_step step;
    uint64_t steps;
    vbss_result whole = vbss_replay_check(replay, &steps);
    for (uint64_t i = 1; i <= steps; i++) {
        TRY(vbss_replay_read(replay, i, &step, sizeof step));
        print(out, &step);
    }
    return whole;
}

static void csv_step(FILE *out, const vbss_replay_logged_step *s)
{
    for (uint32_t i = 0; i < s->input_count; i++) {
        const vbss_record_input *input = &s->inputs[i];
        fprintf(out, "%" PRIu64 ",%.17g,input,%s", s->number, s->time, input_name(input->kind));
        for (uint32_t k = 0; k < 4; k++) {
            fprintf(out, k < input->word_count ? ",%" PRIu32 : ",", input->words[k]);
        }
        for (uint32_t k = 0; k < 12; k++) {
            fprintf(out, k < input->number_count ? ",%.17g" : ",", input->numbers[k]);
        }
        fprintf(out, ",\n");
    }
    for (uint32_t i = 0; i < s->event_count; i++) {
        const uint32_t *e = s->events + 4 * (size_t)i;
        fprintf(out, "%" PRIu64 ",%.17g,event,%s,%" PRIu32 ",%" PRIu32 ",%" PRIu32 ",%s\n",
                s->number, s->time, event_name(e[0]), e[1], e[2], e[3], ",,,,,,,,,,,,");
    }
    fprintf(out, "%" PRIu64 ",%.17g,step,,,,,,%.17g,,,,,,,,,,,,", s->number, s->time, s->h);
    if (s->hashed != 0) {
        fprintf(out, "%016" PRIx64, s->hash);
    }
    fprintf(out, "\n");
}

vbss_result print_csv(FILE *out, vbss_context *context, const log_file *log)
{
    vbss_replay *replay;
    TRY(vbss_replay_create(context, log->bytes, log->count, &replay));
    fprintf(out, "step,time_s,row,kind,word_0,word_1,word_2,word_3");
    for (int i = 0; i < 12; i++) {
        fprintf(out, ",number_%d", i);
    }
    fprintf(out, ",hash\n");
    vbss_result result = print_steps(out, replay, csv_step);
    TRY(vbss_replay_destroy(replay));
    return result;
}

static void json_text(FILE *out, const char *text)
{
    fputc('"', out);
    for (; *text != '\0'; text++) {
        unsigned char c = (unsigned char)*text;
        bool plain = c >= 0x20 && c < 0x7f && c != '"' && c != '\\';
        fprintf(out, plain ? "%c" : "\\u%04x", c);
    }
    fputc('"', out);
}

static void json_input(FILE *out, const vbss_record_input *input)
{
    fprintf(out, "{\"kind\": \"%s\", \"words\": [", input_name(input->kind));
    for (uint32_t k = 0; k < input->word_count; k++) {
        fprintf(out, "%s%" PRIu32, k == 0 ? "" : ", ", input->words[k]);
    }
    fprintf(out, "], \"numbers\": [");
    for (uint32_t k = 0; k < input->number_count; k++) {
        fprintf(out, "%s%.17g", k == 0 ? "" : ", ", input->numbers[k]);
    }
    fprintf(out, "]}");
}

static void json_step(FILE *out, const vbss_replay_logged_step *s)
{
    fprintf(out, "%s\n{\"step\": %" PRIu64 ", \"time_s\": %.17g, \"h_s\": %.17g, \"hash\": ",
            s->number == 1 ? "" : ",", s->number, s->time, s->h);
    if (s->hashed != 0) {
        fprintf(out, "\"%016" PRIx64 "\"", s->hash);
    } else {
        fprintf(out, "null");
    }
    fprintf(out, ", \"inputs\": [");
    for (uint32_t i = 0; i < s->input_count; i++) {
        fprintf(out, i == 0 ? "" : ", ");
        json_input(out, &s->inputs[i]);
    }
    fprintf(out, "], \"events\": [");
    for (uint32_t i = 0; i < s->event_count; i++) {
        const uint32_t *e = s->events + 4 * (size_t)i;
        fprintf(out,
                "%s{\"kind\": \"%s\", \"bodies\": [%" PRIu32 ", %" PRIu32 "], \"number\": %" PRIu32
                "}",
                i == 0 ? "" : ", ", event_name(e[0]), e[1], e[2], e[3]);
    }
    fprintf(out, "]}");
}

vbss_result print_json(FILE *out, vbss_context *context, const log_file *log)
{
    vbss_replay *replay;
    vbss_replay_info info;
    TRY(vbss_replay_create(context, log->bytes, log->count, &replay));
    TRY(vbss_replay_get_info(replay, &info, sizeof info));
    fprintf(out, "{\"written_by\": ");
    json_text(out, info.build_info);
    fprintf(out,
            ", \"hash_interval\": %" PRIu32 ", \"log_bytes\": %" PRIu64 ", \"note_bytes\": %" PRIu32
            ", \"steps\": [",
            info.hash_interval, info.log_bytes, info.note_bytes);
    vbss_result result = print_steps(out, replay, json_step);
    fprintf(out, "\n], \"result\": \"%s\"}\n", vbss_result_name(result));
    TRY(vbss_replay_destroy(replay));
    return result;
}
