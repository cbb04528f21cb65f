/* Checks a log without a scene. Up to the first fault all records are read. After it, only lengths
 * and checksums are checked. */
#include <string.h>

#include "base/api_call.h"
#include "base/check.h"
#include "base/config.h"
#include "base/error.h"
#include "base/memory.h"
#include "record/record.h"

_Static_assert(sizeof(vbss_record_log_report) ==
                   VBSS_SIZE_WITH_POINTERS(vbss_record_log_report, 176u, 8u),
               "published size");

static const uint32_t report_sizes[] = {VBSS_SIZE_WITH_POINTERS(vbss_record_log_report, 168u, 8u),
                                        VBSS_SIZE_WITH_POINTERS(vbss_record_log_report, 176u, 8u),
                                        0};
static const vbss_layout report_layout = {"vbss_record_log_report", NULL, report_sizes};

enum { MAX_FAULTS = sizeof((vbss_record_log_report *)0)->fault_positions / sizeof(uint64_t) };

static void add_fault(vbss_record_log_report *report, const log_fault *fault)
{
    uint32_t n = report->fault_count++;
    if (n == 0) {
        report->result = fault->result;
    }
    if (n < MAX_FAULTS) {
        report->fault_positions[n] = fault->position;
        report->fault_results[n] = fault->result;
        report->fault_problems[n] = fault->problem;
    }
}

/* Reads all records up to the end or to the first fault. */
static vbss_result read_intact_records(replay_object *p, vbss_record_log_report *report)
{
    VBSS_TRY(vbss_replay_open_log(p));
    report->snapshots = 1;
    report->good_bytes = p->log.position;
    while (report->ended == 0) {
        log_record found;
        log_snapshot snapshot;
        VBSS_TRY(vbss_log_read_record(&p->log, report->steps, &p->step, &snapshot, &found));
        report->ended = found.code == LOG_END;
        report->snapshots += found.code == LOG_SNAPSHOT;
        if (found.code == LOG_STEP) {
            report->steps++;
            report->inputs += p->step.input_count;
            report->events += p->step.event_count;
            report->time += p->step.h;
            report->time_lost +=
                vbss_scene_inspect_lost_time(p->step.events, p->step.event_count, p->step.h);
        }
        report->good_bytes = p->log.position;
    }
    return VBSS_OK;
}

/* Skips each faulty record and continues with the checksum that it stores. If that checksum is the
 * damaged part, the next record counts as faulty, too. */
static void find_more_faults(log_reader *log, log_fault *fault, vbss_record_log_report *report)
{
    log_record found;
    for (;;) {
        while (log->position <= fault->position) {
            if (!vbss_log_skip_record(log)) {
                return;
            }
        }
        do {
            if (log->position == log->count) {
                return;
            }
        } while (vbss_log_next(log, &found) == VBSS_OK);
        add_fault(report, fault);
    }
}

static vbss_result check_records(replay_object *p, vbss_record_log_report *report)
{
    log_fault fault = {VBSS_OK, 0, NULL};
    p->log.fault = &fault;
    vbss_result result = read_intact_records(p, report);
    if (fault.result == VBSS_OK || fault.result == VBSS_ERROR_OUT_OF_MEMORY) {
        return result;
    }
    add_fault(report, &fault);
    if (p->log.position >= LOG_PREAMBLE_BYTES) {
        find_more_faults(&p->log, &fault, report);
    }
    return VBSS_OK;
}

vbss_result vbss_record_check_log(vbss_context *context, const uint8_t *bytes, uint64_t count,
                                  vbss_record_log_report *report, uint32_t struct_size)
{
    VBSS_ENTER(context);
    VBSS_TRY(vbss_context_open(context));
    VBSS_TRY(vbss_context_edit(context));
    VBSS_TRY(vbss_check_pointer(context, bytes, "bytes"));
    vbss_record_log_report own = {.struct_size = sizeof own, .log_bytes = count};
    VBSS_TRY(vbss_struct_write(context, &report_layout, &own, report, struct_size));
    if (count > SIZE_MAX) {
        return vbss_fail(context, VBSS_ERROR_CORRUPT, "the log is larger than any memory");
    }
    replay_object *p = vbss_allocate(context, 1, sizeof *p, "check of a log");
    if (p == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    p->context = p->header.context = p->log.context = context;
    p->log.bytes = bytes;
    p->log.count = (size_t)count;
    vbss_result result = check_records(p, &own);
    vbss_replay_close_log(p);
    vbss_release(context, p, 1, sizeof *p);
    VBSS_TRY(result);
    return vbss_struct_write(context, &report_layout, &own, report, struct_size);
}
