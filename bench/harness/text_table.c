#include "harness/text_table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

bool text_table_create(text_table *table, size_t row_capacity, size_t column_capacity)
{
    memset(table, 0, sizeof *table);
    table->row_capacity = row_capacity;
    table->column_capacity = column_capacity;
    table->heads = calloc(column_capacity, sizeof *table->heads);
    table->cells = calloc(row_capacity * column_capacity, sizeof *table->cells);
    table->gaps = calloc(row_capacity, sizeof *table->gaps);
    if (table->heads == NULL || table->cells == NULL || table->gaps == NULL) {
        text_table_destroy(table);
        return false;
    }
    return true;
}

void text_table_destroy(text_table *table)
{
    free(table->heads);
    free(table->cells);
    free(table->gaps);
    memset(table, 0, sizeof *table);
}

size_t text_table_column(text_table *table, const char *head)
{
    for (size_t i = 0; i < table->columns; i++) {
        if (strcmp(table->heads[i], head) == 0) {
            return i;
        }
    }
    if (table->columns == table->column_capacity) {
        return table->columns - 1;
    }
    snprintf(table->heads[table->columns], TEXT_CELL_SIZE, "%s", head);
    return table->columns++;
}

void text_table_row(text_table *table, bool gap)
{
    table->gaps[table->rows] = gap;
    table->rows++;
}

static const char *cell(const text_table *table, size_t row, size_t column)
{
    return table->cells[row * table->column_capacity + column];
}

void text_table_set(text_table *table, size_t column, const char *text)
{
    snprintf(table->cells[(table->rows - 1) * table->column_capacity + column], TEXT_CELL_SIZE,
             "%s", text);
}

void text_table_set_number(text_table *table, size_t column, double value)
{
    char text[TEXT_CELL_SIZE];
    double size = fabs(value);
    if (isnan(value)) {
        return;
    }
    if (size < 1e9 && !(size < floor(size)) && !(size > floor(size))) {
        snprintf(text, sizeof text, "%.0f", value);
    } else if (size < 1e-3 || size >= 1e7) {
        snprintf(text, sizeof text, "%.2e", value);
    } else {
        snprintf(text, sizeof text, "%.*f",
                 size < 1.0     ? 4
                 : size < 100.0 ? 2
                 : size < 1e3   ? 1
                                : 0,
                 value);
    }
    text_table_set(table, column, text);
}

static size_t column_width(const text_table *table, size_t column)
{
    size_t width = 0;
    for (size_t i = 0; i < table->rows; i++) {
        size_t length = strlen(cell(table, i, column));
        width = length > width ? length : width;
    }
    size_t head = strlen(table->heads[column]);
    return width == 0 || width > head ? width : head;
}

void text_table_print(const text_table *table, size_t left, FILE *file)
{
    for (size_t row = 0; row <= table->rows; row++) {
        bool is_head = row == 0;
        size_t blanks = 0; /* owed: a line must not end in blanks */
        if (!is_head && table->gaps[row - 1]) {
            putc('\n', file);
        }
        for (size_t column = 0; column < table->columns; column++) {
            size_t width = column_width(table, column);
            if (width == 0) {
                continue;
            }
            const char *text = is_head ? table->heads[column] : cell(table, row - 1, column);
            size_t rest = width - strlen(text);
            blanks += column < left ? 2 : 2 + rest;
            if (text[0] != '\0') {
                fprintf(file, "%*s%s", (int)blanks, "", text);
                blanks = 0;
            }
            blanks += column < left ? rest : 0;
        }
        putc('\n', file);
    }
}
