/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "feFlowEnergy.H"
#include "emptyPolyPatch.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(feFlowEnergy, 0);
    addToRunTimeSelectionTable(functionObject, feFlowEnergy, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Places in the list of powers
enum { VISCOUS, EDDY, STABILISATION, WEIGHT, TRANSPORT, PATCHES };

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::hasFlowEnergy& Foam::functionObjects::feFlowEnergy::fluid() const
{
    return dynamic_cast<const hasFlowEnergy&>(region());
}


Foam::scalarField Foam::functionObjects::feFlowEnergy::powers(const flowEnergy& e) const
{
    scalarField p(PATCHES + patches_.size());
    p[VISCOUS] = e.viscous;
    p[EDDY] = e.eddy;
    p[STABILISATION] = e.stabilisation;
    p[WEIGHT] = e.weight;
    p[TRANSPORT] = e.transport;
    const scalarField boundary(fluid().boundaryPowers());
    forAll(patches_, i) p[PATCHES + i] = boundary[patches_[i]];
    return p;
}


Foam::scalar Foam::functionObjects::feFlowEnergy::boundary() const
{
    scalar sum = 0;
    for (label i = PATCHES; i < work_.size(); ++i) sum += work_[i];
    return sum;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::feFlowEnergy::feFlowEnergy
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    feFunctionObject(name, runTime, dict, "flowEnergy"),
    scheme_(0)
{
    read(dict);
    const flowEnergy start(fluid().energy());
    kinetic_ = start.kinetic;
    compression_ = start.compression;
    initial_ = kinetic_ + compression_;

    wordList columns
    ({
        "kinetic", "compression", "viscous", "eddy", "stabilisation", "weight", "transport", "boundary", "scheme"
    });
    for (const label patchi : patches_) columns.append(mesh_.boundaryMesh()[patchi].name());
    writeHeader(file(), "Energies and what has changed them, J (in 2-D per metre of depth)");
    writeColumns(file(), columns);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::feFlowEnergy::read(const dictionary& dict)
{
    feFunctionObject::read(dict);
    reportUnknownEntries(dict, wordList());
    if (!dynamic_cast<const hasFlowEnergy*>(&region()))
    {
        FatalIOErrorInFunction(dict)
            << "Region " << mesh_.name() << " is no fluid, whose energy could be told" << exit(FatalIOError);
    }
    patches_.clear();
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (!pp.coupled() && !isA<emptyPolyPatch>(pp)) patches_.append(pp.index());
    }
    return true;
}


bool Foam::functionObjects::feFlowEnergy::execute()
{
    const flowEnergy now(fluid().energy());
    kinetic_ = now.kinetic;
    compression_ = now.compression;

    // Towards the middle of the step, where the stage is later
    const feTimeScheme& ts = region().timeScheme();
    const scalarField stage(powers(now));
    if (power_.empty())
    {
        power_ = stage;
        work_ = scalarField(stage.size(), 0);
    }
    if (!ts.steady()) work_ += ts.deltaT()*(stage - (ts.alphaF() - 0.5)*(stage - power_));
    power_ = stage;

    scheme_ =
        initial_ + work_[WEIGHT] + boundary() - work_[VISCOUS] - work_[EDDY] - work_[STABILISATION]
      - work_[TRANSPORT] - kinetic_ - compression_;
    setResult("kinetic", kinetic_);
    setResult("compression", compression_);
    setResult("scheme", scheme_);
    return true;
}


bool Foam::functionObjects::feFlowEnergy::write()
{
    if (work_.empty()) return true;
    Log << type() << " " << name() << " write:" << nl
        << "    kinetic " << kinetic_ << " J, compression " << compression_
        << " J, taken by the time scheme " << scheme_ << " J" << nl << endl;
    scalarList row
    ({
        kinetic_, compression_, work_[VISCOUS], work_[EDDY], work_[STABILISATION], work_[WEIGHT],
        work_[TRANSPORT], boundary(), scheme_
    });
    for (label i = PATCHES; i < work_.size(); ++i) row.append(work_[i]);
    writeRow(file(), row);
    return true;
}


// ************************************************************************* //
