/* The table of kernels, as the extension reads it: one for each set of instructions. */
#ifndef KLEINFORM_TABLE_H
#define KLEINFORM_TABLE_H

#include <stddef.h>

/* Inputs and outputs of a kernel, at most. */
#define FIELDS 20

struct kernel {
    const char *name;
    const char *signature;
    const char *words;
    int inputs;
    int outputs;
    /* Numbers of a pose that go in and come out. */
    int given;
    int returned;
    /* Mathematical axes of each field, 0 where it has fewer than two. */
    int shapes[FIELDS][2];
    void (*one)(const double *, double *);
    void (*lanes)(const double *, double *);
};

struct table {
    size_t count;
    unsigned long checksum;
    const struct kernel *kernels;
};

#endif
