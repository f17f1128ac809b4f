/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coupledSystem.H"
#include "meshFiles.H"
#include "trapsOff.H"
#include "checkMemory.H"
#include "regionProperties.H"
#include "unknownEntries.H"
#include "subDictOrEmpty.H"
#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- What is in controlDict without anybody who reads it
static void reportControls(const Time& runTime)
{
    const wordList ofOthers({"adjustTimeStep", "maxCo", "maxDeltaT"});
    for (const word& control : ofOthers)
    {
        if (!runTime.controlDict().found(control)) continue;
        IOWarningInFunction(runTime.controlDict())
            << "Entry " << control << " has no effect: for automatic steps use"
            << " timeStepControl of system/feSolution" << endl;
    }
    wordList known
    ({
        "application", "libs", "regionSolvers", "functions", "startFrom", "startTime", "beginTime", "stopAt",
        "endTime", "deltaT", "writeControl", "writeInterval", "writeFrequency", "purgeWrite", "writeFormat",
        "writePrecision", "writeVersion", "writeCompression", "timeFormat", "timePrecision", "graphFormat",
        "runTimeModifiable", "secondaryWriteControl", "secondaryWriteInterval", "secondaryPurgeWrite",
        "profiling", "DebugSwitches", "InfoSwitches", "OptimisationSwitches", "DimensionSets",
        "DimensionedConstants"
    });
    known.append(ofOthers);
    reportUnknownEntries(runTime.controlDict(), known);
}


//- An entry is the second of two words, of which the first is the default
static bool isSecond(const dictionary& solution, const word& keyword, const wordList& valid)
{
    const word found(solution.lookupOrDefault<word>(keyword, valid[0]));
    if (!valid.found(found))
    {
        FatalIOErrorInFunction(solution)
            << "Unknown " << keyword << ' ' << found << ". Valid: " << valid << exit(FatalIOError);
    }
    return found == valid[1];
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::coupledSystem::readRegions()
{
    const dictionary& solvers = runTime_.controlDict().subDict("regionSolvers");
    const regionProperties properties(runTime_);

    wordList names;
    forAllConstIters(properties, iter)
    {
        names.append(iter.val());
        if (iter.key() == "fluid" || iter.key() == "solid") continue;
        WarningInFunction
            << "constant/regionProperties lists regions " << iter.val() << " as " << iter.key()
            << ", expected fluid or solid. What they are is told by regionSolvers" << endl;
    }
    for (const word& name : names)
    {
        if (std::count(names.begin(), names.end(), name) == 1) continue;
        FatalErrorInFunction
            << "Region " << name << " is more than once in constant/regionProperties. Regions: "
            << names << exit(FatalError);
    }

    for (const entry& e : solvers)
    {
        if (names.found(e.keyword())) continue;
        FatalIOErrorInFunction(solvers)
            << "regionSolvers names region '" << e.keyword()
            << "', which is not in constant/regionProperties. Regions: "
            << names << exit(FatalIOError);
    }
    for (const word& name : names)
    {
        const word type(solvers.get<word>(name));
        checkMeshFiles(runTime_, name);
        meshes_.append
        (
            new fvMesh
            (
                IOobject(name, runTime_.timeName(), runTime_, IOobject::MUST_READ)
            )
        );
        regions_.append
        (
            feRegion::New
            (
                type, solvers, meshes_.last(), solution_.subDict("linearSolver")
            ).ptr()
        );
        regions_.last().timeScheme().setDeltaT(runTime_.deltaTValue());
    }
}


void Foam::coupledSystem::readInterfaces()
{
    IOobject io
    (
        "couplingProperties", runTime_.constant(), runTime_,
        IOobject::READ_IF_PRESENT, IOobject::NO_WRITE, false
    );
    const IOdictionary dict(io);
    reportUnknownEntries(dict, {"interfaces"});
    const dictionary interfaces(subDictOrEmpty(dict, "interfaces"));
    for (const entry& e : interfaces)
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(interfaces)
                << "Entry '" << e.keyword() << "' of interfaces is no dictionary, expected "
                << e.keyword() << " { type ...; fluid {...} solid {...} }" << exit(FatalIOError);
        }
        interfaces_.append(feInterface::New(e.keyword(), e.dict(), regions_).ptr());
        for (label i = 0; i + 1 < interfaces_.size(); ++i) interfaces_.last().checkApart(interfaces_[i]);
    }

    for (feRegion& region : regions_)
    {
        labelList patches;
        for (const feInterface& i : interfaces_)
        {
            if (i.moves() && &i.follower() == &region) patches.append(i.followerPatches());
        }
        if (!patches.empty()) region.follower()->setFollowing(patches);
    }
}


void Foam::coupledSystem::makeSystem()
{
    norms_.clear();
    tangent_.clear();
    unknowns_.reset(new systemUnknowns(regions_, interfaces_));

    UPtrList<elementScatter> scatter;
    for (feRegion& region : regions_)
    {
        for (elementScatter& s : region.scatter()) scatter.append(&s);
    }
    tangent_.reset
    (
        new tangentSolver
        (
            map(), constraints(), scatter, solution_.subDict("linearSolver"),
            tangentSolver::modes.getOrDefault
            (
                "tangent", subDictOrEmpty(solution_, "newton"), tangentSolver::mode::AUTOMATIC
            )
        )
    );
    for (feRegion& region : regions_) region.colour(tangent_->K());
    norms_.reset(new residualNorms(unknowns_(), regions_));

    for (scalarField* f : {&R_, &dx_, &raw_}) *f = scalarField(map().nUnknowns(), 0);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupledSystem::coupledSystem(Time& runTime)
:
    runTime_(runTime),
    solution_
    (
        IOobject
        (
            "feSolution", runTime.system(), runTime,
            IOobject::MUST_READ, IOobject::NO_WRITE
        )
    ),
    newton_(subDictOrEmpty(solution_, "newton")),
    staticStage_(solution_),
    writer_(*this),
    deltaT0_(runTime.deltaTValue()),
    nIterations_(0),
    firstNorm_(-1),
    failedNorm_(-1)
{
    trapsOff::inThreads();
    reportUnknownEntries
    (
        solution_,
        {"newton", "linearSolver", "timeStepControl", "initialRates", "initialVelocities", "staticStage"}
    );
    reportControls(runTime);
    readRegions();
    readInterfaces();
    const bool consistent = isSecond(solution_, "initialRates", {"nil", "consistent"});
    const bool projected = isSecond(solution_, "initialVelocities", {"given", "projected"});
    if (readState()) return;
    makeSystem();
    followAtStart();
    for (feInterface& i : interfaces_) i.setFollowed();
    staticStage_.select(regions_, runTime_.value());
    if (projected && !startContinuously())
    {
        FatalIOErrorInFunction(solution_)
            << "initialVelocities projected: none were found that obey continuity and what is given at"
            << " boundaries. " << outcome().c_str() << nl << placeOfFailure().c_str() << exit(FatalIOError);
    }
    times_ = systemTimes();   // of the steps to come
    if (consistent) startConsistently();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupledSystem::discretise(const UList<const stateMap*>& maps)
{
    const factorPolicy policy(tangent_->policy());
    const momentPtr factorsAt(factorsAt_);
    bool same = true;
    forAll(regions_, r)
    {
        same = same && !maps[r];
        regions_[r].discretise(maps[r]);
    }
    makeSystem();
    if (same) remakeFactors(factorsAt, policy);
}


void Foam::coupledSystem::advance()
{
    systemTimes::timer timer(times_, systemTimes::OUTPUT);
    for (feRegion& region : regions_)
    {
        region.advance();
        region.derive();
    }
    deltaT0_ = runTime_.deltaTValue();
}


void Foam::coupledSystem::report() const
{
    for (const feRegion& region : regions_)
    {
        Info<< "Region " << region.name() << ": " << region.type() << ", "
            << returnReduce(region.fe().nElements(), sumOp<label>())
            << " elements of order " << region.fe().order() << " in "
            << region.fe().dim() << "-D, time scheme "
            << region.timeScheme().type() << nl;
    }
    Info<< "Unknowns: " << unknowns_->nFree() << " on " << Pstream::nProcs()
        << " rank(s)" << nl;
    const scalar memory = tangent_->solver().stats().memory;
    if (memory > 0)
    {
        Info<< "Memory: the factors need about " << fourDigits(memory) << " MB, " << fourDigits(freeMemory())
            << " MB are free on this machine" << nl;
    }
    Info<< endl;
}


void Foam::coupledSystem::reportTimes()
{
    times_.endStep(Info);
}


void Foam::coupledSystem::summary() const
{
    times_.summary(Info);
    Info<< "Factors: " << tangent_->solver().stats() << nl;
    for (const feRegion& region : regions_) region.reportSolvers(Info);
    Info<< endl;
}


// ************************************************************************* //
