/* Opens and closes the tasks of the lines. These functions use no context, because the cycle calls
 * them in its own thread to recover from an error. */
#include <stdio.h>
#include <string.h>

#include "device/nidaqmx.h"

static void end_task(const daq_functions *daq, daq_task *task)
{
    if (*task != NULL) {
        daq->stop_task(*task);
        daq->clear_task(*task);
        *task = NULL;
    }
}

void vbss_nidaqmx_close_tasks(nidaqmx_object *o)
{
    vbss_nidaqmx_switch_off(o);
    end_task(&o->daq, &o->analog);
    end_task(&o->daq, &o->digital);
    o->lines_open = o->levels_written = false;
}

static int32_t open_inputs(nidaqmx_object *o, const char **what)
{
    const int32_t terminal =
        o->config.terminal == VBSS_NIDAQMX_TERMINAL_DIFFERENTIAL ? DAQ_DIFFERENTIAL : DAQ_RSE;
    *what = "inputs";
    int32_t code = o->daq.create_task("", &o->analog);
    for (uint32_t i = 0; code >= 0 && i < o->handle_count; i++) {
        *what = o->inputs[i];
        code = o->daq.create_voltage_input(o->analog, o->inputs[i], "", terminal, o->config.low,
                                           o->config.high, DAQ_VOLTS, NULL);
    }
    if (code >= 0) {
        *what = "start of inputs";
        code = o->daq.start_task(o->analog);
    }
    return code;
}

/* The timeout starts short, so a slow device may need several attempts. */
static int32_t switch_off_patiently(nidaqmx_object *o)
{
    int32_t code = vbss_nidaqmx_switch_off(o);
    for (int i = 0; vbss_nidaqmx_remedy(code) == DAQ_RETRY && i < DAQ_OPENING_ATTEMPTS; i++) {
        code = vbss_nidaqmx_switch_off(o);
    }
    return code;
}

/* Makes one channel of all lines, and switches the solenoids off at once. */
static int32_t open_lines(nidaqmx_object *o, const char **what)
{
    if (!o->has_lines) {
        return 0;
    }
    *what = "lines";
    int32_t code = o->daq.create_task("", &o->digital);
    if (code >= 0) {
        *what = o->channel;
        code = o->daq.create_digital_output(o->digital, o->channel, "", DAQ_CHANNEL_FOR_ALL_LINES);
    }
    o->lines_open = code >= 0;
    return o->lines_open ? switch_off_patiently(o) : code;
}

int32_t vbss_nidaqmx_open_tasks(nidaqmx_object *o, const char **what)
{
    int32_t code = open_inputs(o, what);
    return code >= 0 ? open_lines(o, what) : code;
}

/* ---- names of lines */

/* NI-DAQmx Base writes whole ports: finds the port and the bit of a line, such as
 * "Dev1/port0/line3". Returns the length of the name of the port; 0: it is no such name. */
static size_t split_line(const char *line, uint32_t *bit)
{
    const size_t tail = sizeof "/line0" - 1, length = strlen(line);
    if (length <= tail) {
        return 0;
    }
    const char *end = line + length - tail, digit = line[length - 1];
    if (memcmp(end, "/line", tail - 1) != 0 || digit < '0' || digit > '7') {
        return 0;
    }
    *bit = (uint32_t)(digit - '0');
    return length - tail;
}

static bool name_port(nidaqmx_object *o)
{
    size_t length = 0;
    const char *port = NULL;
    for (uint32_t i = 0; i < o->handle_count; i++) {
        if (o->lines[i][0] == '\0') {
            continue;
        }
        size_t found = split_line(o->lines[i], &o->line_bits[i]);
        if (found == 0 ||
            (port != NULL && (found != length || memcmp(port, o->lines[i], found) != 0))) {
            return false;
        }
        port = o->lines[i];
        length = found;
    }
    if (port != NULL) {
        memcpy(o->channel, port, length);
        o->channel[length] = '\0';
    }
    return true;
}

bool vbss_nidaqmx_name_channel(nidaqmx_object *o)
{
    if (o->daq.is_base) {
        return name_port(o);
    }
    for (uint32_t i = 0; i < o->handle_count; i++) {
        if (o->lines[i][0] != '\0') {
            size_t used = strlen(o->channel);
            snprintf(o->channel + used, sizeof o->channel - used, "%s%s", used > 0 ? "," : "",
                     o->lines[i]);
        }
    }
    return true;
}
