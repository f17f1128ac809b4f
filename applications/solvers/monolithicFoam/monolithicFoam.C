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
#include "caseTime.H"
#include "coupledSystem.H"
#include "coupledInterfaceReport.H"
#include "stepControl.H"
#include "regionRemeshing.H"
#include "timeError.H"
#include "exitOnError.H"
#include "refuseBlanks.H"
#include "stockFunctionObjects.H"
#include "caseChecks.H"

using namespace Foam;

//- The smallest step has failed: the last good state, if it is not the initial
//  one, is written, and the run ends
static void stop(caseTime& runTime, coupledSystem& problem, const stepControl& step)
{
    const bool written = runTime.timeIndex() > runTime.startTimeIndex();
    if (written)
    {
        problem.advance();
        runTime.writeNow();
        runTime.complete();
    }
    FatalErrorInFunction
        << step.failure().c_str() << (written ? "The last good state has been written. " : "")
        << problem.newton().advice() << exit(FatalError);
}


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
    refuseBlanks(argc, argv);
    #include "setRootCase.H"
    exitOnError();
    Info<< "Create time\n" << endl;
    caseTime runTime(args);
    checkFunctionObjects(runTime);

    coupledSystem problem(runTime);
    const coupledInterfaceReport interfaces(runTime, problem);
    remeshing remesh(problem);
    stepControl step(runTime, problem.solution());
    problem.report();
    checkCase(problem, runTime.deltaTValue());
    if (args.found("dry-run"))
    {
        Info<< "Dry run: the case can be run" << nl << "End\n" << endl;
        return 0;
    }

    timeError error(runTime, problem.regions(), step.wantsError());
    while (step.next())
    {
        problem.store();
        error.store();
        while (step.attempt())
        {
            if (problem.step())
            {
                step.accept(problem.nIterations(), error.estimate(runTime));
            }
            else
            {
                const string where(problem.placeOfFailure());
                problem.restore();
                step.bisect(problem.outcome(), where, problem.smallerMayHelp());
                if (problem.newton().outcome() == newtonControl::INVERTED_ELEMENT && remesh.update(true))
                {
                    problem.store();
                    error.store();
                }
            }
        }
        if (step.failed()) stop(runTime, problem, step);

        problem.advance();
        remesh.update();
        runTime.write();

        problem.reportTimes();
        runTime.printExecutionTime(Info);
    }

    problem.summary();
    Info<< "End\n" << endl;
    return 0;
}


// ************************************************************************* //
