/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    monolithicFoam

Description
    Fluid-structure interaction by one system of finite elements: ALE flow,
    total-Lagrangian solids, moving meshes. Takes its physics from the case:
    a fluid or a solid alone runs, too.
\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "Time.H"
#include "coupledSystem.H"
#include "coupledInterfaceReport.H"

using namespace Foam;

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Fluid-structure interaction by one system of finite elements: regions"
        " and their solvers from regionSolvers in system/controlDict, interfaces"
        " from constant/couplingProperties"
    );
    argList::addBoolOption
    (
        "dry-run",
        "Read and check the case, report its size, and stop"
    );
    #include "setRootCase.H"
    #include "createTime.H"

    coupledSystem problem(runTime);
    const coupledInterfaceReport interfaces(runTime, problem);
    problem.report();
    if (args.found("dry-run"))
    {
        Info<< "Dry run: the case can be run" << nl << "End\n" << endl;
        return 0;
    }

    while (runTime.loop())
    {
        Info<< "Time = " << runTime.timeName() << nl;

        problem.store();
        if (!problem.step())
        {
            // Back to the last good state, written if it is not the initial one
            problem.restore();
            runTime.setTime(runTime.value() - runTime.deltaTValue(), runTime.timeIndex() - 1);
            if (runTime.timeIndex() > runTime.startTimeIndex())
            {
                problem.advance();
                runTime.writeNow();
                problem.writeState();
            }
            FatalErrorInFunction
                << "The step from time " << runTime.timeName() << " with deltaT "
                << runTime.deltaTValue() << " did not converge: "
                << feRegion::outcomeName(problem.newton().outcome()) << " after "
                << problem.newton().nIterations() << " iterations." << nl
                << "The last good state has been written. Try a smaller deltaT,"
                << " for a steady case a ramp of its loads." << exit(FatalError);
        }

        problem.advance();
        runTime.write();
        if (runTime.writeTime()) problem.writeState();

        problem.reportTimes();
        runTime.printExecutionTime(Info);
    }

    problem.summary();
    Info<< "End\n" << endl;
    return 0;
}


// ************************************************************************* //
