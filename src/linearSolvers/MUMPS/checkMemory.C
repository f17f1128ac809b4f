/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "checkMemory.H"
#include "Pstream.H"
#include "scalarList.H"
#include "messageStream.H"
#include "error.H"
#include "OSspecific.H"
#include <fstream>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::freeMemory()
{
    std::ifstream file("/proc/meminfo");
    std::string word;
    while (file >> word)
    {
        scalar kB = 0;
        if (word == "MemAvailable:" && file >> kB) return kB/1000;
    }
    return GREAT;
}


void Foam::checkMemory
(
    const scalar expected,
    const label limit,
    const label nUnknowns
)
{
    scalarList expectedOf(Pstream::nProcs()), freeOf(Pstream::nProcs());
    wordList hosts(Pstream::nProcs());
    const label me = Pstream::myProcNo();
    expectedOf[me] = expected;
    freeOf[me] = freeMemory();
    hosts[me] = hostName();
    Pstream::gatherList(expectedOf);
    Pstream::gatherList(freeOf);
    Pstream::gatherList(hosts);
    if (!Pstream::master()) return;

    const auto warn = [&](const scalar needed, const string& where, const scalar has)
    {
        WarningInFunction
            << "The factors of " << nUnknowns << " unknowns will take about " << needed << " MB "
            << where.c_str() << ", of " << has << " MB. Use fewer cells or a lower order, more"
            << " machines, or blockLowRank 1e-8 in linearSolver" << endl;
    };
    forAll(hosts, rank)
    {
        if (limit > 0 && expectedOf[rank] > limit)
        {
            warn(expectedOf[rank], "on rank " + Foam::name(rank) + ", more than maxMemory", limit);
            return;
        }
        scalar together = 0;
        forAll(hosts, other) if (hosts[other] == hosts[rank]) together += expectedOf[other];
        if (together <= freeOf[rank]) continue;
        warn(together, "on machine " + hosts[rank] + ", more than is free", freeOf[rank]);
        return;
    }
}


// ************************************************************************* //
