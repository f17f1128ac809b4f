/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    feRemesh

Description
    Exchange of a part of a region's mesh, with all fields, by the region's
    remeshDict (regionRemeshing.H), as monolithicFoam does it in the run.

        feRemesh [-region <name>] [-time <time>] [-dry-run] [-overwrite] [-parallel]

    -region     default: the one region that has a remeshDict
    -time       default: the start time of controlDict
    -dry-run    tell the quality of the mesh, what the criteria say of it and
                how many cells would be exchanged
    -overwrite  write to the same time (a mesh in constant that has not been
                moved: there), else to the next one, deltaT later

    With extent bad, the cells are those that the criteria call bad, with their
    layers; with extent all, all that may be exchanged.
\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "timeSelector.H"
#include "caseTime.H"
#include "exitOnError.H"
#include "refuseBlanks.H"
#include "regionRemeshing.H"
#include "OSspecific.H"

using namespace Foam;

//- The region that is to be remeshed
static label regionOf(const coupledSystem& system, const argList& args)
{
    DynamicList<label> found;
    wordList names;
    forAll(system.regions(), r)
    {
        const feRegion& region = system.regions()[r];
        names.append(region.name());
        if (args.found("region") ? region.name() == args["region"] : regionRemeshing::wanted(region)) found.append(r);
    }
    if (found.size() != 1)
    {
        FatalErrorInFunction
            << found.size() << (args.found("region") ? " regions have that name" : " regions have a remeshDict")
            << ", expected one. Regions: " << names << nl << "Name one with -region" << exit(FatalError);
    }
    if (!regionRemeshing::wanted(system.regions()[found[0]]))
    {
        FatalErrorInFunction
            << "Region " << names[found[0]] << " has no constant/" << names[found[0]]
            << "/remeshDict; for an example see etc/caseDicts/remeshing" << exit(FatalError);
    }
    return found[0];
}


//- The mesh is in constant and as it was there
static bool undeformed(const feRegion& region)
{
    const scalar moved = returnReduce(max(mag(region.motion().D)()), maxOp<scalar>());
    return region.mesh().facesInstance() == region.mesh().time().constant() && moved == 0;
}


//- Without the state that is there for a restart: a case that had none starts
//  from its fields
static void removeState(const coupledSystem& system, const Time& runTime)
{
    for (const feRegion& region : system.regions())
    {
        const fileName dir(runTime.timePath()/region.name());
        rmDir(dir/"restart");
        for (const fileName& file : readDir(dir, fileName::FILE)) if (file.startsWith("restart.")) rm(dir/file);
    }
}


// * * * * * * * * * * * * * * * * Main Program  * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote("Exchange of a part of a region's mesh, with its fields");
    timeSelector::addOptions(false, true);
    #include "addRegionOption.H"
    argList::addBoolOption("dry-run", "The quality of the mesh and what would be exchanged, no more");
    argList::addBoolOption("overwrite", "Write to the same time");
    refuseBlanks(argc, argv);
    #include "setRootCase.H"
    exitOnError();
    caseTime runTime(args);
    const instantList times(timeSelector::selectIfPresent(runTime, args));
    if (times.size() != 1)
    {
        FatalErrorInFunction << times.size() << " times are selected, expected one" << exit(FatalError);
    }
    runTime.setTime(times[0], 0);

    coupledSystem system(runTime);
    const label regioni = regionOf(system, args);
    feRegion& region = system.regions()[regioni];
    regionRemeshing remeshing(system, regioni);
    string why;
    const labelHashSet bad(remeshing.bad(why));
    remeshing.report(bad, why);
    if (args.found("dry-run"))
    {
        Info<< "Dry run: nothing is written" << nl << "End\n" << endl;
        return 0;
    }

    if (!remeshing.any(bad))
    {
        Info<< "No cell is bad: nothing is written" << nl << "End\n" << endl;
        return 0;
    }

    const bool toConstant = args.found("overwrite") && undeformed(region);
    const bool hadState = isDir(runTime.timePath()/region.name()/"restart");
    if (!args.found("overwrite")) ++runTime;
    if (!remeshing.exchange(why.empty() ? string("as asked for") : why, bad))
    {
        FatalErrorInFunction << "The mesh has not been exchanged" << exit(FatalError);
    }
    if (toConstant) remeshing.toConstant();
    runTime.writeNow();
    runTime.complete();
    if (!hadState) removeState(system, runTime);
    Info<< "Written to " << runTime.timeName() << (toConstant ? ", the mesh to constant" : "") << nl
        << "End\n" << endl;
    return 0;
}


// ************************************************************************* //
