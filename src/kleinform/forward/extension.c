/* SPDX-License-Identifier: BSD-3-Clause */
/* The compiled solver of the forward displacement, as a module. solve.py calls it first, and
   does itself what it leaves. */
#define PY_SSIZE_T_CLEAN
#define NPY_NO_DEPRECATED_API NPY_2_0_API_VERSION
#include <Python.h>
#include <numpy/arrayobject.h>

#include "simd.h"
#include "solver.h"
#include "tables.h"

static solver *active;
static const char *instructions;

static void use(const char *name, solver *solver)
{
    instructions = name;
    active = solver;
}

/* Use the instructions of this name; 0 if this machine or this build has not got them. */
static int use_named(const char *name)
{
    if (!simd_supported(name))
        return 0;
#ifdef KLEINFORM_X86
    if (strcmp(name, "avx512") == 0)
        use("avx512", kleinform_solver_avx512);
    else if (strcmp(name, "avx2") == 0)
        use("avx2", kleinform_solver_avx2);
    else
#endif
        use("baseline", kleinform_solver_baseline);
    return 1;
}

/* Arrays ---------------------------------------------------------------------------------- */

/* What arrives: float64, one number or three a row. A new reference. */
static PyArrayObject *input(PyObject *object, int columns, npy_intp rows)
{
    PyArrayObject *array =
        (PyArrayObject *)PyArray_FROM_OTF(object, NPY_DOUBLE, NPY_ARRAY_IN_ARRAY);
    if (!array)
        return NULL;
    if (PyArray_NDIM(array) == (columns > 1 ? 2 : 1) &&
        (rows < 0 || PyArray_DIM(array, 0) == rows) &&
        (columns == 1 || PyArray_DIM(array, 1) == columns))
        return array;
    Py_DECREF(array);
    PyErr_Format(PyExc_ValueError, "radius (N,), position (N, 3), lengths (N, 3) are needed");
    return NULL;
}

static void free_memory(PyObject *capsule)
{
    free(PyCapsule_GetPointer(capsule, NULL));
}

/* An array that owns the numbers, also if it can not be made. */
static PyObject *output(double **numbers, int axes, npy_intp count)
{
    npy_intp shape[3] = {count, 3, 3};
    const size_t bytes = (size_t)count * (axes == 3 ? 9 : 3) * sizeof(double);
    /* What was reserved and not used goes back; a pointer to nothing is none to an array. */
    double *memory = realloc(*numbers, bytes ? bytes : 1);
    if (!memory)
        return PyErr_NoMemory();
    *numbers = memory;
    PyObject *capsule = PyCapsule_New(memory, NULL, free_memory);
    if (!capsule)
        return NULL;
    *numbers = NULL;
    PyObject *array = PyArray_SimpleNewFromData(axes, shape, NPY_DOUBLE, memory);
    if (!array) {
        Py_DECREF(capsule);
        return NULL;
    }
    if (PyArray_SetBaseObject((PyArrayObject *)array, capsule) < 0) {
        Py_DECREF(array);
        return NULL;
    }
    return array;
}

/* The module's functions ------------------------------------------------------------------ */

static PyObject *solved(const struct given *given)
{
    npy_intp rows = (npy_intp)given->rows;
    struct modes modes = {0, 0, NULL, NULL, NULL, NULL};
    PyObject *results[5] = {NULL, NULL, NULL, NULL, NULL};
    PyObject *tuple = NULL;
    int good = (results[0] = PyArray_SimpleNew(1, &rows, NPY_INT64)) != NULL;
    if (good) {
        int64_t *count = PyArray_DATA((PyArrayObject *)results[0]);
        solver *chosen = active;
        Py_BEGIN_ALLOW_THREADS
        good = chosen(given, count, &modes);
        Py_END_ALLOW_THREADS
        if (!good)
            PyErr_NoMemory();
    }
    double **numbers[4] = {
        &modes.rotation, &modes.directions, &modes.platform_joints, &modes.extension};
    for (int k = 0; k < 4 && good; ++k) {
        results[1 + k] = output(numbers[k], k < 3 ? 3 : 2, (npy_intp)modes.count);
        good = results[1 + k] != NULL;
    }
    if (good)
        tuple = PyTuple_Pack(5, results[0], results[1], results[2], results[3], results[4]);
    for (int k = 0; k < 5; ++k)
        Py_XDECREF(results[k]);
    for (int k = 0; k < 4; ++k)
        free(*numbers[k]);
    return tuple;
}

static PyObject *module_solve(PyObject *module, PyObject *args)
{
    (void)module;
    PyObject *objects[3], *result = NULL;
    struct given given;
    if (!PyArg_ParseTuple(args, "OOOd", objects, objects + 1, objects + 2, &given.tolerance))
        return NULL;
    PyArrayObject *radius = input(objects[0], 1, -1), *position = NULL, *lengths = NULL;
    if (radius)
        position = input(objects[1], 3, PyArray_DIM(radius, 0));
    if (position)
        lengths = input(objects[2], 3, PyArray_DIM(radius, 0));
    if (lengths) {
        given.rows = (size_t)PyArray_DIM(radius, 0);
        given.radius = PyArray_DATA(radius);
        given.position = PyArray_DATA(position);
        given.lengths = PyArray_DATA(lengths);
        result = solved(&given);
    }
    Py_XDECREF(radius);
    Py_XDECREF(position);
    Py_XDECREF(lengths);
    return result;
}

static PyObject *module_instructions(PyObject *module, PyObject *Py_UNUSED(none))
{
    (void)module;
    return PyUnicode_FromString(instructions);
}

static PyObject *module_use(PyObject *module, PyObject *name)
{
    (void)module;
    const char *text = PyUnicode_AsUTF8(name);
    if (!text)
        return NULL;
    return PyBool_FromLong(use_named(text));
}

static PyMethodDef methods[] = {
    {"solve", module_solve, METH_VARARGS,
     "solve(radius, position, lengths, tolerance) -> (count, rotation, directions,\n"
     "platform_joints, extension): the number of modes of each row, -1 where it is left to\n"
     "others, and the modes of all rows one after the other, in their order."},
    {"instructions", module_instructions, METH_NOARGS,
     "The instructions in use: baseline, avx2 or avx512."},
    {"use", module_use, METH_O,
     "Use other instructions; False if this machine has not got them."},
    {NULL, NULL, 0, NULL},
};

static struct PyModuleDef definition = {
    PyModuleDef_HEAD_INIT,
    .m_name = "_compiled",
    .m_doc = "The forward displacement, compiled.",
    .m_size = -1,
    .m_methods = methods,
};

PyMODINIT_FUNC PyInit__compiled(void)
{
    import_array();
    kleinform_fill_tables();
    if (!use_named("avx512") && !use_named("avx2"))
        use_named("baseline");
    return PyModule_Create(&definition);
}
