/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Factorisation in a workspace that grows, for MUMPSSolver.

\*---------------------------------------------------------------------------*/

#include "MUMPSSolver.H"
#include "MUMPSInstance.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::feLinearSolver::outcome
Foam::MUMPSSolver::outcomeOf(const int status) const
{
    switch (status)
    {
        case -6:
        case -10:
            return outcome::SINGULAR;

        case -8: case -9: case -11: case -13: case -14:
        case -15: case -17: case -19: case -20:
            return outcome::OUT_OF_MEMORY;
    }

    return status < 0 ? outcome::FAILED : outcome::OK;
}


void Foam::MUMPSSolver::setWorkspace(const scalar n)
{
    // MUMPS' own allocation keeps count of compression and of a limit
    if (controls_.blockLowRank > 0 || controls_.maxMemory > 0)
    {
        return;
    }

    // In millions, with a minus sign, where the integer is too short
    const bool large = n > 2e9;
    const int size = large ? -int(n/1e6 + 1) : int(max(n, scalar(1)));

    workspace_.resize(large ? -1000000L*size : size);
    (*mumps_)->wk_user = workspace_.data();
    (*mumps_)->lwk_user = workspace_.data() ? size : 0;
}


Foam::feLinearSolver::outcome Foam::MUMPSSolver::tryFactorise()
{
    MUMPSInstance& mumps = *mumps_;

    for (label attempt = 0; ; ++attempt)
    {
        mumps.icntl(14) = memoryRelaxation_;
        const int status = mumps.run(MUMPSInstance::FACTORISE);
        const outcome result = outcomeOf(status);

        // -13: the machine has no more, -19: the user allows no more
        const bool mayHelp =
            result == outcome::OUT_OF_MEMORY
         && status != -13
         && !(status == -19 && controls_.maxMemory > 0);

        if (!mayHelp || attempt == 5)
        {
            if (result == outcome::OUT_OF_MEMORY || result == outcome::FAILED)
            {
                Info<< "MUMPS: error " << status << ' ' << mumps.infog(2)
                    << " in the factorisation" << endl;
            }
            return result;
        }

        const label previous = memoryRelaxation_;
        memoryRelaxation_ = 100 + 2*previous;
        Info<< "MUMPS: workspace too small (error " << status
            << "), memoryRelaxation " << previous << " -> "
            << memoryRelaxation_ << endl;

        if (workspace_.size())
        {
            setWorkspace(2*scalar(workspace_.size()));
        }
    }
}


// ************************************************************************* //
