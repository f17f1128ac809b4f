/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coupledSystem.H"
#include "trapsOff.H"
#include "regionProperties.H"
#include "IFstream.H"
#include "OFstream.H"
#include "OSspecific.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::coupledSystem::readRegions()
{
    const dictionary& solvers = runTime_.controlDict().subDict("regionSolvers");
    const regionProperties properties(runTime_);

    wordList names;
    forAllConstIters(properties, iter) names.append(iter.val());

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
        meshes_.append
        (
            new fvMesh
            (
                IOobject(name, runTime_.timeName(), runTime_, IOobject::MUST_READ)
            )
        );
        regions_.append(feRegion::New(type, solvers, meshes_.last()).ptr());
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
    const dictionary interfaces(dict.subOrEmptyDict("interfaces"));
    for (const entry& e : interfaces)
    {
        const word type(e.dict().get<word>("type"));
        if (type != "matching")
        {
            FatalIOErrorInFunction(e.dict())
                << "Unknown interface type " << type << ". Valid: (matching)"
                << exit(FatalIOError);
        }
        interfaces_.append(new matchingInterface(e.keyword(), e.dict(), regions_));
    }

    for (feRegion& region : regions_)
    {
        labelList patches;
        for (const matchingInterface& i : interfaces_)
        {
            if (&i.fluid() == &region) patches.append(i.fluidPatch());
        }
        if (!patches.empty()) region.setInterface(patches);
    }
}


void Foam::coupledSystem::makeUnknowns()
{
    // One key for every node of the case
    List<labelList> key(regions_.size());
    label offset = 0;
    forAll(regions_, r)
    {
        key[r] = regions_[r].fe().key();
        for (label& k : key[r]) k += offset;
        offset += returnReduce(regions_[r].fe().nNodes(), sumOp<label>());
    }
    for (const matchingInterface& i : interfaces_)
    {
        label f = 0, s = 0;
        forAll(regions_, r)
        {
            if (&regions_[r] == &i.fluid()) f = r;
            if (&regions_[r] == &i.solid()) s = r;
        }
        i.match(key[s], key[f]);
    }

    // Nodes of this rank
    Map<label> nodeOf;
    DynamicList<label> nodeKeys, nUnknowns;
    List<labelList> systemNode(regions_.size());
    forAll(regions_, r)
    {
        systemNode[r].setSize(key[r].size());
        forAll(key[r], n)
        {
            const label nRegion = regions_[r].nUnknowns(n);
            const auto found = nodeOf.cfind(key[r][n]);
            if (found.found())
            {
                systemNode[r][n] = *found;
                nUnknowns[*found] = max(nUnknowns[*found], nRegion);
                continue;
            }
            systemNode[r][n] = nodeKeys.size();
            nodeOf.insert(key[r][n], nodeKeys.size());
            nodeKeys.append(key[r][n]);
            nUnknowns.append(nRegion);
        }
    }
    map_.reset(new nodeMap(nodeKeys, nUnknowns));
    forAll(regions_, r) regions_[r].connect(systemNode[r], map_());

    R_.setSize(map_->nUnknowns(), 0);
    for (scalarField* f : {&dx_, &b_, &y_, &rowScale_, &copies_}) *f = R_;

    for (const feRegion& region : regions_)
    {
        if (!const_cast<feRegion&>(region).interfaceMotion()) continue;
        for (const label n : region.systemNode()) copies_[map_->start(n)] = 1;
    }
    map_->sum(copies_);
}


void Foam::coupledSystem::makeBlocks()
{
    // Vector unknowns of shared nodes count with the solid
    scalarField block(map_->nUnknowns(), -1);
    label nBlocks = 0;
    forAll(regions_, r)
    {
        const feRegion& region = regions_[r];
        const label dim = region.fe().dim();
        const bool solid = regions_[r].interfaceMotion();
        label hasScalar = 0;
        forAll(region.systemNode(), n)
        {
            const label start = map_->start(region.systemNode()[n]);
            for (label c = 0; c < region.nUnknowns(n); ++c)
            {
                const bool taken = c < dim && block[start + c] >= 0 && !solid;
                if (!taken) block[start + c] = nBlocks + (c < dim ? 0 : 1);
                if (c >= dim) hasScalar = 1;
            }
        }
        reduce(hasScalar, maxOp<label>());
        const word vectorName(region.unknownName(0));
        blockNames_.append(region.name() + '.' + vectorName.substr(0, vectorName.find('.')));
        blockRegion_.append(r);
        if (hasScalar)
        {
            blockNames_.append(region.name() + '.' + region.unknownName(dim));
            blockRegion_.append(r);
        }
        nBlocks = blockNames_.size();
    }

    // Ranks that see only one of the regions at a shared node
    map_->maximum(block);
    block_.setSize(block.size());
    forAll(block, u) block_[u] = max(label(block[u]), 0);
    elementSize_.setSize(regions_.size());
    forAll(regions_, r) elementSize_[r] = regions_[r].fe().meanSize();
    for (scalarField* f : {&scales_, &norms_, &firstNorms_}) *f = scalarField(nBlocks, 0);
}


void Foam::coupledSystem::makeConstraints()
{
    constraints_.reset(new dofConstraints(map_->nUnknowns()));
    for (const feRegion& region : regions_) region.constrain(constraints_());

    // A rank may have one side only of an interface's node
    constraints_->share(map_());
    constraints_->close();

    UPtrList<elementScatter> scatter;
    for (feRegion& region : regions_)
    {
        for (elementScatter& s : region.scatter()) scatter.append(&s);
    }
    K_.reset(new feMatrix(map_(), map_(), constraints_.get(), scatter));
    factors_.reset(new feFactors(map_(), K_(), solution_.subDict("linearSolver")));
    factorised_ = false;
}


Foam::fileName Foam::coupledSystem::stateFile(const label r) const
{
    return runTime_.path()/runTime_.timeName()/regions_[r].name()/"restart"/"feState";
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
            IOobject::MUST_READ_IF_MODIFIED, IOobject::NO_WRITE
        )
    ),
    newton_(solution_.subOrEmptyDict("newton")),
    assembled_(false),
    factorised_(false),
    makingCost_(0),
    factorCost_(0),
    factorUses_(0),
    nLinear_(0)
{
    trapsOff::inThreads();
    readRegions();
    readInterfaces();
    makeUnknowns();
    makeBlocks();
    makeConstraints();
    gmres_.reset
    (
        new gmres
        (
            map_(),
            solution_.subDict("linearSolver").lookupOrDefault<label>("maxIter", 60)
        )
    );
    readState();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::coupledSystem::nUnknowns() const
{
    label n = 0;
    for (const label u : map_->ownedUnknowns()) if (constraints_->isFree(u)) ++n;
    return returnReduce(n, sumOp<label>());
}


void Foam::coupledSystem::store()
{
    for (feRegion& region : regions_) region.state().store();
}


void Foam::coupledSystem::restore()
{
    for (feRegion& region : regions_) region.state().restore();
}


void Foam::coupledSystem::advance()
{
    systemTimes::timer timer(times_, systemTimes::OUTPUT);
    for (feRegion& region : regions_)
    {
        region.advance();
        region.derive();
    }
}


void Foam::coupledSystem::writeState()
{
    systemTimes::timer timer(times_, systemTimes::OUTPUT);
    forAll(regions_, r)
    {
        const fileName file(stateFile(r));
        mkDir(file.path());
        OFstream os(file, IOstream::BINARY);
        os  << "monolithicFoamState" << token::SPACE << label(1) << nl;
        const scalarField time(1, runTime_.value());
        os  << time << token::SPACE << runTime_.timeIndex() << nl;
        regions_[r].state().write(os);
        if (!os.good())
        {
            FatalErrorInFunction
                << "Could not write " << file << ": is the disk full?"
                << exit(FatalError);
        }
    }
    assembled_ = false;
    factorised_ = false;
}


bool Foam::coupledSystem::readState()
{
    bool any = false;
    forAll(regions_, r)
    {
        const fileName file(stateFile(r));
        if (!isFile(file, false)) continue;
        any = true;
        IFstream is(file, IOstream::BINARY);
        const word header(is);
        const label version = header == "monolithicFoamState" ? readLabel(is) : -1;
        if (header != "monolithicFoamState" || version != 1)
        {
            FatalIOErrorInFunction(is)
                << "Found '" << header << ' ' << version
                << "', expected 'monolithicFoamState 1'" << nl
                << "Remove this file to start from the point fields"
                << exit(FatalIOError);
        }
        const scalarField time(is);
        const label index = readLabel(is);
        regions_[r].state().read(is);
        regions_[r].state().store();
        runTime_.setTime(time[0], index);
    }
    if (any) Info<< "State read at time " << runTime_.timeName() << nl;
    return any;
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
    Info<< "Unknowns: " << nUnknowns() << " on " << Pstream::nProcs()
        << " rank(s)" << nl << endl;
}


void Foam::coupledSystem::reportTimes()
{
    times_.endStep(Info);
}


void Foam::coupledSystem::summary() const
{
    times_.summary(Info);
    Info<< "Factors: " << factors_->solver().stats() << nl;
    for (const feRegion& region : regions_)
    {
        if (const feLinearSolver* motion = region.motionSolver())
        {
            Info<< "Factors of the mesh motion of " << region.name() << ": "
                << motion->stats() << nl;
        }
    }
    Info<< endl;
}


// ************************************************************************* //
