/* SPDX-License-Identifier: BSD-3-Clause */
/* Quick checks of arrays: True where every rule is kept, False where a closer look is needed.

   They look at plain float64 arrays alone. Whatever is False here is looked at again with
   NumPy, which also finds the words for what is wrong. So is what has no codes, but None. */
#define PY_SSIZE_T_CLEAN
#define NPY_NO_DEPRECATED_API NPY_2_0_API_VERSION
#include <Python.h>
#include <numpy/arrayobject.h>

#include "checks.h"
#include "simd.h"

static const struct checks *checks = &kleinform_checks_baseline;

/* The numbers of a C-ordered float64 array with these trailing axes, or NULL. */
static const double *numbers_of(PyObject *value, int axes, const npy_intp *trailing)
{
    if (!PyArray_CheckExact(value))
        return NULL;
    PyArrayObject *array = (PyArrayObject *)value;
    const int more = PyArray_NDIM(array) - axes;
    if (PyArray_TYPE(array) != NPY_DOUBLE || !PyArray_ISCARRAY_RO(array) || more < 0)
        return NULL;
    for (int axis = 0; axis < axes; ++axis)
        if (PyArray_DIM(array, more + axis) != trailing[axis])
            return NULL;
    return (const double *)PyArray_DATA(array);
}

static int read_double(PyObject *value, double *number)
{
    *number = PyFloat_AsDouble(value);
    return !(*number == -1.0 && PyErr_Occurred());
}

static int wrong_count(Py_ssize_t given, Py_ssize_t wanted)
{
    if (given == wanted)
        return 0;
    PyErr_Format(PyExc_TypeError, "%zd arguments are needed, %zd arrived", wanted, given);
    return 1;
}

/* sound(position, rotation, smallest, largest, defect) */
static PyObject *sound(PyObject *module, PyObject *const *args, Py_ssize_t count)
{
    static const npy_intp trailing[2] = {3, 3};
    double smallest, largest, defect;
    (void)module;
    if (wrong_count(count, 5) || !read_double(args[2], &smallest) ||
        !read_double(args[3], &largest) || !read_double(args[4], &defect))
        return NULL;
    const double *position = numbers_of(args[0], 1, trailing);
    const double *rotation = numbers_of(args[1], 2, trailing);
    if (!position || !rotation)
        Py_RETURN_FALSE;
    const size_t numbers = (size_t)PyArray_SIZE((PyArrayObject *)args[0]);
    const size_t entries = (size_t)PyArray_SIZE((PyArrayObject *)args[1]);
    int good;
    Py_BEGIN_ALLOW_THREADS
    good = checks->sized(position, numbers, smallest, largest) &&
           checks->rotations(rotation, entries / 9, defect);
    Py_END_ALLOW_THREADS
    return PyBool_FromLong(good);
}

/* sized(values, smallest, largest) */
static PyObject *sized(PyObject *module, PyObject *const *args, Py_ssize_t count)
{
    double smallest, largest;
    (void)module;
    if (wrong_count(count, 3) || !read_double(args[1], &smallest) ||
        !read_double(args[2], &largest))
        return NULL;
    const double *values = numbers_of(args[0], 0, NULL);
    if (!values)
        Py_RETURN_FALSE;
    const size_t size = (size_t)PyArray_SIZE((PyArrayObject *)args[0]);
    int good;
    Py_BEGIN_ALLOW_THREADS
    good = checks->sized(values, size, smallest, largest);
    Py_END_ALLOW_THREADS
    return PyBool_FromLong(good);
}

struct scales {
    const double *at;
    size_t step;
    size_t count;
};

/* Scales from a C-ordered float64 array, or from a column of one. */
static int read_scales(PyObject *value, struct scales *scales)
{
    scales->step = 1;
    scales->at = numbers_of(value, 0, NULL);
    if (!scales->at) {
        if (!PyArray_CheckExact(value))
            return 0;
        PyArrayObject *array = (PyArrayObject *)value;
        const npy_intp step = PyArray_NDIM(array) == 1 ? PyArray_STRIDE(array, 0) : 0;
        if (PyArray_TYPE(array) != NPY_DOUBLE || !PyArray_ISBEHAVED_RO(array) || step <= 0 ||
            step % (npy_intp)sizeof(double) != 0)
            return 0;
        scales->at = (const double *)PyArray_DATA(array);
        scales->step = (size_t)step / sizeof(double);
    }
    scales->count = (size_t)PyArray_SIZE((PyArrayObject *)value);
    return 1;
}

/* none_zero(values, scales, factor) */
static PyObject *none_zero(PyObject *module, PyObject *const *args, Py_ssize_t count)
{
    double factor, scale;
    (void)module;
    if (wrong_count(count, 3) || !read_double(args[2], &factor))
        return NULL;
    const double *values = numbers_of(args[0], 0, NULL);
    if (!values)
        Py_RETURN_FALSE;
    const size_t size = (size_t)PyArray_SIZE((PyArrayObject *)args[0]);
    struct scales scales = {&scale, 0, 1};
    if (PyFloat_CheckExact(args[1]))
        scale = PyFloat_AS_DOUBLE(args[1]);
    else if (!read_scales(args[1], &scales))
        Py_RETURN_FALSE;
    if (scales.count == 0 || size % scales.count != 0)
        return PyBool_FromLong(size == 0);
    const size_t width = scales.step ? size / scales.count : 1;
    int good;
    Py_BEGIN_ALLOW_THREADS
    good = checks->none_zero(values, size / width, scales.at, scales.step, width, factor);
    Py_END_ALLOW_THREADS
    return PyBool_FromLong(good);
}

/* A factor and its scales, as many as there are poses times `width`; 0 if they are not plain. */
static int read_factor(
    PyObject *const *args, npy_intp poses, npy_intp width, struct factor *factor)
{
    factor->values = numbers_of(args[0], 0, NULL);
    factor->scales = numbers_of(args[1], 0, NULL);
    return factor->values && factor->scales &&
           PyArray_SIZE((PyArrayObject *)args[0]) == poses * width &&
           PyArray_SIZE((PyArrayObject *)args[1]) == poses * width;
}

/* classes(joints, incidence, extension, extension_scale, central, central_scale, wrist,
   wrist_scale, orientation, orientation_scale, radius, factor) */
static PyObject *classes(PyObject *module, PyObject *const *args, Py_ssize_t count)
{
    static const npy_intp trailing[1] = {6}, limbs[1] = {3};
    struct survey survey;
    double factor;
    (void)module;
    if (wrong_count(count, 12) || !read_double(args[11], &factor))
        return NULL;
    survey.joints = numbers_of(args[0], 1, trailing);
    survey.incidence = numbers_of(args[1], 1, limbs);
    survey.radius = numbers_of(args[10], 0, NULL);
    if (!survey.joints || !survey.incidence || !survey.radius)
        Py_RETURN_NONE;
    PyArrayObject *joints = (PyArrayObject *)args[0];
    const npy_intp poses = PyArray_SIZE(joints) / 6;
    const npy_intp radii = PyArray_SIZE((PyArrayObject *)args[10]);
    survey.radius_step = radii == 1 ? 0 : 1;
    if ((radii != 1 && radii != poses) || PyArray_SIZE((PyArrayObject *)args[1]) != poses * 3 ||
        !read_factor(args + 2, poses, 3, &survey.extension) ||
        !read_factor(args + 4, poses, 1, &survey.central) ||
        !read_factor(args + 6, poses, 1, &survey.wrist) ||
        !read_factor(args + 8, poses, 1, &survey.orientation))
        Py_RETURN_NONE;
    PyObject *codes = PyArray_SimpleNew(PyArray_NDIM(joints) - 1, PyArray_DIMS(joints), NPY_UINT8);
    if (!codes)
        return NULL;
    uint8_t *written = PyArray_DATA((PyArrayObject *)codes);
    Py_BEGIN_ALLOW_THREADS
    checks->classes(&survey, (size_t)poses, factor, written);
    Py_END_ALLOW_THREADS
    return codes;
}

static PyMethodDef methods[] = {
    {"sized", (PyCFunction)(void (*)(void))sized, METH_FASTCALL,
     "sized(values, smallest, largest): whether every value is 0 or of a size between them."},
    {"sound", (PyCFunction)(void (*)(void))sound, METH_FASTCALL,
     "sound(position, rotation, smallest, largest, defect): whether every pose is one."},
    {"none_zero", (PyCFunction)(void (*)(void))none_zero, METH_FASTCALL,
     "none_zero(values, scales, factor): whether no value is finite and |value| <= factor scale;"
     " a scale a row, a scale a value, or one for all."},
    {"classes", (PyCFunction)(void (*)(void))classes, METH_FASTCALL,
     "classes(joints, incidence, extension, extension_scale, central, central_scale, wrist,"
     " wrist_scale, orientation, orientation_scale, radius, factor): a code for each pose, or None."},
    {NULL, NULL, 0, NULL},
};

static struct PyModuleDef definition = {
    PyModuleDef_HEAD_INIT,
    .m_name = "_checks",
    .m_doc = "Quick checks of arrays, and the classes of poses.",
    .m_size = -1,
    .m_methods = methods,
};

PyMODINIT_FUNC PyInit__checks(void)
{
    import_array();
#ifdef KLEINFORM_X86
    if (simd_supported("avx512"))
        checks = &kleinform_checks_avx512;
    else if (simd_supported("avx2"))
        checks = &kleinform_checks_avx2;
#endif
    return PyModule_Create(&definition);
}
