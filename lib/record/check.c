/* What is wrong with a log and where, without a scene: all that is good is read, and beyond a fault only as far
 * as lengths and checksums tell. */
#include <string.h>

#include "base/check.h"
#include "base/error.h"
#include "record/record.h"

_Static_assert(sizeof(vbss_log_report) == 232, "published size");

static const uint32_t report_sizes[] = {232, 0};
static const vbss_layout report_layout = {"vbss_log_report", NULL, report_sizes};

enum { FAULTS = sizeof((vbss_log_report *)0)->fault_positions / sizeof(uint64_t) };

static void note(vbss_log_report *report, const log_fault *fault)
{
    uint32_t n = report->fault_count++;
    if (n == 0) {
        report->result = fault->result;
    }
    if (n < FAULTS) {
        report->fault_positions[n] = fault->at;
        report->fault_results[n] = fault->result;
        report->fault_problems[n] = fault->problem;
    }
}

/* Everything up to the end, or to the first fault. */
static vbss_result read_good(replay_object *p, vbss_log_report *report)
{
    VBSS_TRY(vbss_log_read_begin(p));
    report->snapshots = 1;
    report->good_bytes = p->log.at;
    while (report->ended == 0) {
        log_found found;
        log_snapshot snapshot;
        VBSS_TRY(vbss_log_read(&p->log, report->steps, &p->step, &snapshot, &found));
        report->ended = found.code == LOG_END;
        report->snapshots += found.code == LOG_SNAPSHOT;
        if (found.code == LOG_STEP) {
            report->steps++;
            report->inputs += p->step.input_count;
            report->events += p->step.event_count;
            report->time += p->step.h;
        }
        report->good_bytes = p->log.at;
    }
    return VBSS_OK;
}

/* The record with a fault tells the checksum that the next one covers, if that was not what was hit. */
static void read_rest(log_reader *log, log_fault *fault, vbss_log_report *report)
{
    log_found found;
    for (;;) {
        while (log->at <= fault->at) {
            if (!vbss_log_skip(log)) {
                return;
            }
        }
        do {
            if (log->at == log->count) {
                return;
            }
        } while (vbss_log_next(log, &found) == VBSS_OK);
        note(report, fault);
    }
}

static vbss_result check(replay_object *p, vbss_log_report *report)
{
    log_fault fault = {VBSS_OK, 0, NULL};
    p->log.fault = &fault;
    vbss_result result = read_good(p, report);
    if (fault.result == VBSS_OK || fault.result == VBSS_ERROR_OUT_OF_MEMORY) {
        return result;
    }
    note(report, &fault);
    if (p->log.at >= LOG_FRONT) {
        read_rest(&p->log, &fault, report);
    }
    return VBSS_OK;
}

vbss_result vbss_log_check(vbss_context *context, const uint8_t *bytes, uint64_t count,
                           vbss_log_report *report, uint32_t struct_size)
{
    VBSS_TRY(vbss_context_open(context));
    VBSS_TRY(vbss_context_edit(context));
    VBSS_TRY(vbss_check_pointer(context, bytes, "bytes"));
    vbss_log_report own = {.struct_size = sizeof own, .log_bytes = count};
    VBSS_TRY(vbss_struct_write(context, &report_layout, &own, report, struct_size));
    VBSS_TRY(vbss_check_arithmetic(context));
    if (count > SIZE_MAX) {
        return vbss_fail(context, VBSS_ERROR_CORRUPT, "the log is larger than any memory");
    }
    replay_object *p = vbss_allocate(context, 1, sizeof *p, "check of a log");
    if (p == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    p->context = p->head.context = p->log.context = context;
    p->log.bytes = bytes;
    p->log.count = (size_t)count;
    vbss_result result = check(p, &own);
    vbss_log_free_begin(p);
    vbss_release(context, p, 1, sizeof *p);
    VBSS_TRY(result);
    return vbss_struct_write(context, &report_layout, &own, report, struct_size);
}
