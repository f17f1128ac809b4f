/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stopSignals.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include <csignal>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static volatile std::sig_atomic_t signalled = 0;

extern "C" void monolithicFoamStop(int) { signalled = 1; }

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::stopSignals::listen()
{
    std::signal(SIGTERM, monolithicFoamStop);
    std::signal(SIGUSR1, monolithicFoamStop);
}


bool Foam::stopSignals::arrived()
{
    return returnReduce(bool(signalled), orOp<bool>());
}


// ************************************************************************* //
