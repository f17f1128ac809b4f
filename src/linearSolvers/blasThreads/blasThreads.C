/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "blasThreads.H"
#include "Pstream.H"
#include "OSspecific.H"

#include <thread>

// Weak: absent in the reference BLAS
extern "C"
{
    void openblas_set_num_threads(int) __attribute__((weak));
    int openblas_get_num_threads(void) __attribute__((weak));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::blasThreads::blasThreads(const label n)
:
    previous_(openblas_get_num_threads ? openblas_get_num_threads() : 1)
{
    if (openblas_set_num_threads && n != previous_)
    {
        openblas_set_num_threads(n);
    }
}


Foam::blasThreads::~blasThreads()
{
    if
    (
        openblas_set_num_threads
     && openblas_get_num_threads
     && openblas_get_num_threads() != previous_
    )
    {
        openblas_set_num_threads(previous_);
    }
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::label Foam::blasThreads::nDefault()
{
    label n = 0;

    if (!Foam::read(getEnv("OMP_NUM_THREADS"), n) || n < 1)
    {
        n = label(std::thread::hardware_concurrency())/Pstream::nProcs();
    }

    return max(n, 1);
}


// ************************************************************************* //
