/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    benchmark-linearSolvers

Description
    Times of analysis, factorisation and solution of flow systems:

        benchmark-linearSolvers -nDims 2 -order 2 -nElements 58
            -solver "type MUMPS; threads 1;"

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "MUMPSSolver.H"
#include "../flowSystem.H"
#include "IStringStream.H"

using namespace Foam;

int main(int argc, char *argv[])
{
    argList::noBanner();
    argList::noCheckProcessorDirectories();
    argList::addOption("nDims", "label", "2 or 3");
    argList::addOption("order", "label", "1: stabilised, 2: Taylor-Hood");
    argList::addOption("nElements", "label", "elements along an edge");
    argList::addOption("mu", "scalar", "viscosity");
    argList::addOption("rhoByDt", "scalar", "density by time step");
    argList::addOption("solver", "string", "the solver's dictionary");
    argList::addOption("repeat", "label", "factorisations");
    argList::addBoolOption("closed", "no outlet: singular");
    argList::addBoolOption("debug", "show the pivots");
    argList args(argc, argv, false, true, false);

    flowSystem::parameters p;
    MUMPSSolver::debug = args.found("debug");
    args.readIfPresent("nDims", p.nDims);
    args.readIfPresent("order", p.order);
    args.readIfPresent("nElements", p.nElements);
    args.readIfPresent("mu", p.mu);
    args.readIfPresent("rhoByDt", p.rhoByDt);
    p.closed = args.found("closed");
    const flowSystem system(p);

    IStringStream stream
    (
        args.lookupOrDefault<string>("solver", "type MUMPS;")
    );
    const dictionary dict(stream);
    autoPtr<feLinearSolver> solver(feLinearSolver::New(dict));
    solver->analyse(system.pattern);
    const scalar analysisTime = solver->stats().analysisTime;

    const scalarField exact(system.manufactured());
    const scalarField b(system.product(exact));
    scalar factorTime = GREAT, solveTime = GREAT;
    const label nRepeat = args.lookupOrDefault<label>("repeat", 5);

    for (label i = 0; i < nRepeat; ++i)
    {
        const auto result = solver->factorise(system.values);
        if (result != feLinearSolver::outcome::OK)
        {
            Info<< feLinearSolver::outcomeNames[result] << " unknown "
                << solver->singularUnknown() << endl;
            break;
        }
        factorTime = min(factorTime, solver->stats().factorTime);
        for (label j = 0; j < 10; ++j)
        {
            scalarField x(b);
            solver->solve(x);
            solveTime = min(solveTime, solver->stats().solveTime);
        }
    }

    scalarField x(b);
    solver->solve(x);
    const scalar error = gMax(mag(x - exact));
    const scalar residual =
        gMax(mag(system.product(x) - b))/gMax(mag(b));

    Info<< "n " << system.pattern.unknowns.size()
        << " analysis " << analysisTime
        << " factor " << 1000*factorTime << " ms"
        << " solve " << 1000*solveTime << " ms"
        << " nnz " << solver->stats().nNonzeros
        << " flop " << solver->stats().nFlops
        << " MB " << solver->stats().memory
        << " error " << error << " residual " << residual << endl;

    return 0;
}


// ************************************************************************* //
