/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The state in memory and on disk.
\*---------------------------------------------------------------------------*/

#include "coupledSystem.H"
#include "restartFields.H"
#include "trapsOff.H"
#include "IStringStream.H"
#include "OStringStream.H"
#include "OSspecific.H"
#include "SHA1.H"
#include "SHA1Digest.H"
#include <fstream>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Half a unit of the last digit of a time's name
static scalar resolution(const word& name)
{
    const auto e = name.find_first_of("eE");
    const std::string mantissa = name.substr(0, e);
    const auto dot = mantissa.find('.');
    const label decimals = dot == std::string::npos ? 0 : label(mantissa.size() - dot) - 1;
    const label exponent = e == std::string::npos ? 0 : std::atoi(name.substr(e + 1).c_str());
    return 0.51*::pow(10.0, exponent - decimals);
}


//- What tells a mesh and its decomposition from others: ranks, nodes, cells and
//  the sum of the positions
static scalarList signature(const feRegion& region)
{
    const vector sum(Foam::sum(region.fe().points()));
    return
    {
        scalar(Pstream::nProcs()), scalar(region.fe().nNodes()), scalar(region.mesh().nCells()),
        sum.x(), sum.y(), sum.z()
    };
}


static bool same(const UList<scalar>& a, const UList<scalar>& b)
{
    if (a.size() != b.size()) return false;
    scalar size = 0;
    forAll(a, i) size = max(size, mag(a[i]));
    forAll(a, i) if (mag(a[i] - b[i]) > 1e-6*size) return false;
    return true;
}


//- One list of numbers, exact in binary
static void put(Ostream& os, const scalarList& list) { os << list << nl; }

static scalarList take(Istream& is) { return scalarList(is); }

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::coupledSystem::moment Foam::coupledSystem::now() const
{
    moment m;
    m.regions.setSize(regions_.size());
    forAll(regions_, r) m.regions[r] = const_cast<feRegion&>(regions_[r]).state().copy();
    m.time = runTime_.value();
    m.deltaT = runTime_.deltaTValue();
    m.index = runTime_.timeIndex();
    return m;
}


void Foam::coupledSystem::set(const moment& m)
{
    staticStage_.select(regions_, m.time - m.deltaT);
    forAll(regions_, r)
    {
        regions_[r].state().set(m.regions[r]);
        regions_[r].timeScheme().setDeltaT(m.deltaT, deltaT0_);
    }
    runTime_.setDeltaT(m.deltaT, false);
    runTime_.setTime(m.time, m.index);
}


void Foam::coupledSystem::remakeFactors
(
    const momentPtr& at,
    const factorPolicy& policy
)
{
    factorsAt_ = at;
    if (!policy.has)
    {
        tangent_->remember(policy);
        return;
    }
    const trapsOff guard;
    const moment present(now());
    set(*at);
    assemble(true);
    if (tangent_->remake(policy, times_) != tangentSolver::outcome::OK) tangent_->drop();
    set(present);
}


Foam::fileName Foam::coupledSystem::stateFile(const label r) const
{
    return runTime_.path()/runTime_.timeName()/regions_[r].name()/"restart"/"feState";
}


Foam::coupledSystem::stateWriter::stateWriter(coupledSystem& system)
:
    regIOobject
    (
        IOobject
        (
            "feState", system.runTime_.timeName(), system.runTime_,
            IOobject::NO_READ, IOobject::AUTO_WRITE
        )
    ),
    system_(system)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupledSystem::store()
{
    times_.startStep();
    for (feRegion& region : regions_) region.state().shift();
    kept_.at = now();
    kept_.factorsAt = factorsAt_;
    kept_.policy = tangent_->policy();
    kept_.nFactorisations = tangent_->nFactorisations();
}


void Foam::coupledSystem::restore()
{
    set(kept_.at);
    if (tangent_->nFactorisations() != kept_.nFactorisations)
    {
        remakeFactors(kept_.factorsAt, kept_.policy);
    }
    else
    {
        tangent_->remember(kept_.policy);
        factorsAt_ = kept_.factorsAt;
    }
}


void Foam::coupledSystem::writeState()
{
    systemTimes::timer timer(times_, systemTimes::OUTPUT);
    const factorPolicy& policy = tangent_->policy();
    const moment made(policy.has ? *factorsAt_ : moment());
    forAll(regions_, r)
    {
        OStringStream content(IOstream::BINARY);
        put(content, signature(regions_[r]));
        put(content, {runTime_.value(), runTime_.deltaTValue(), scalar(runTime_.timeIndex())});
        put
        (
            content,
            {
                scalar(policy.has), policy.making, policy.total, scalar(policy.uses),
                made.time, made.deltaT, scalar(made.index)
            }
        );
        put(content, policy.has ? made.regions[r] : scalarList());
        regions_[r].state().write(content);

        // Under another name until it is whole
        const fileName file(stateFile(r)), part(file + ".part");
        const std::string text(content.str());
        mkDir(file.path());
        {
            std::ofstream os(part, std::ios::binary);
            os  << "monolithicFoamState 2 " << text.size() << ' ' << SHA1(text).digest().str() << '\n'
                << text;
            os.flush();
            if (!os.good())
            {
                FatalErrorInFunction
                    << "Could not write " << part << ": is the disk full?"
                    << exit(FatalError);
            }
        }
        mv(part, file);
        restartFields(regions_[r]).write();
    }
}


bool Foam::coupledSystem::readFields(const string& why)
{
    bool found = true;
    forAll(regions_, r) found = restartFields(regions_[r]).found() && found;
    if (!returnReduce(found, andOp<bool>()))
    {
        WarningInFunction
            << why.c_str() << ", nor fields restart.*: time " << runTime_.timeName()
            << " starts from pointU, pointP, pointD. Rates are nil, and values at mid-side"
            << " nodes are the means of their ends; so the first steps differ from those of a"
            << " run that was not interrupted." << endl;
        return false;
    }
    forAll(regions_, r)
    {
        restartFields(regions_[r]).read();
        regions_[r].state().shift();
    }
    for (feInterface& i : interfaces_) i.setFollowed();
    makeSystem();
    Info<< why.c_str() << ": state read from the fields restart.* at time "
        << runTime_.timeName() << nl;
    compareFields();
    return true;
}


void Foam::coupledSystem::compareFields() const
{
    for (const feRegion& region : regions_)
    {
        // As pointU and U
        const pointVectorField& field = region.motionConditions();
        const vectorField* state = region.state().find<vector>(word(field.name().substr(5)));
        if (!state) continue;
        scalar size = 0, difference = 0;
        forAll(region.fe().vertexPoint(), n)
        {
            size = max(size, mag((*state)[n]));
            difference = max(difference, mag((*state)[n] - field[region.fe().vertexPoint()[n]]));
        }
        reduce(size, maxOp<scalar>());
        reduce(difference, maxOp<scalar>());
        if (difference <= 1e-3*size) continue;
        WarningInFunction
            << "The state of time " << runTime_.timeName() << " counts, not the values of "
            << field.objectPath() << ", which differ from it by " << difference << '.' << nl
            << "    To start from the fields remove the directory restart and the fields restart.*"
            << " of this time" << endl;
    }
}


bool Foam::coupledSystem::readState()
{
    // All regions on all ranks, or none
    label nFound = 0;
    forAll(regions_, r) nFound += isFile(stateFile(r), false);
    const label nWanted = returnReduce(regions_.size(), sumOp<label>());
    reduce(nFound, sumOp<label>());

    if (nFound == 0)
    {
        const bool any = returnReduce(restartFields(regions_[0]).found(), orOp<bool>());
        return runTime_.value() > 0 || any ? readFields("There is no restart/feState") : false;
    }
    if (nFound < nWanted) return readFields("Some regions or ranks have no restart/feState");

    PtrList<IStringStream> content(regions_.size());
    bool fits = true;
    forAll(regions_, r)
    {
        const fileName file(stateFile(r));
        std::ifstream is(file, std::ios::binary);
        std::string header, digest, text;
        label version = -1, size = -1;
        is >> header;
        if (header == "monolithicFoamState") is >> version;
        if (header != "monolithicFoamState" || version != 2)
        {
            FatalErrorInFunction
                << "File " << file << ": found '" << header.c_str() << ' ' << version
                << "', expected 'monolithicFoamState 2'" << nl
                << "Remove the directories restart of this time to start from the fields"
                << exit(FatalError);
        }
        is >> size >> digest;
        is.get();
        std::ostringstream rest;
        rest << is.rdbuf();
        text = rest.str();
        if (label(text.size()) != size || SHA1(text).digest().str() != digest)
        {
            FatalErrorInFunction
                << "File " << file << " is truncated or corrupt: found " << label(text.size())
                << " bytes, expected " << size << " with the checksum " << digest.c_str() << nl
                << "Remove the directories restart of this time to start from the fields, or"
                << " this time to restart from the one before" << exit(FatalError);
        }
        content.set(r, new IStringStream(text, IOstream::BINARY));
        fits = fits && same(take(content[r]), signature(regions_[r]));
    }
    if (!returnReduce(fits, andOp<bool>()))
    {
        return readFields("The restart/feState is of another mesh, decomposition or kind of elements");
    }

    moment present, factorsAt;
    factorPolicy policy;
    factorsAt.regions.setSize(regions_.size());
    forAll(regions_, r)
    {
        const scalarList time(take(content[r])), p(take(content[r]));
        present.time = time[0];
        present.deltaT = time[1];
        present.index = label(time[2]);
        policy.has = p[0] > 0;
        policy.making = p[1];
        policy.total = p[2];
        policy.uses = label(p[3]);
        factorsAt.time = p[4];
        factorsAt.deltaT = p[5];
        factorsAt.index = label(p[6]);
        factorsAt.regions[r] = take(content[r]);
        regions_[r].state().read(content[r]);
        regions_[r].state().shift();
    }

    // The name of the directory has fewer digits; one of another time has been
    // copied, and starts anew
    const scalar deltaT = runTime_.deltaTValue();
    if (mag(present.time - runTime_.value()) <= resolution(runTime_.timeName()))
    {
        runTime_.setTime(present.time, present.index);
    }
    else
    {
        WarningInFunction
            << "The restart/feState is of time " << present.time << " and stands in "
            << runTime_.timeName() << ": it starts at the latter" << endl;
    }
    for (feInterface& i : interfaces_) i.setFollowed();
    makeSystem();
    remakeFactors(std::make_shared<moment>(factorsAt), policy);
    runTime_.setDeltaT(deltaT, false);
    deltaT0_ = present.deltaT;
    Info<< "State read at time " << runTime_.timeName() << nl;
    compareFields();
    return true;
}


// ************************************************************************* //
