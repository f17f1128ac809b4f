/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "feFlowEnergy.H"
#include "flowEnergy.H"
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


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::feFlowEnergy::feFlowEnergy
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    feFunctionObject(name, runTime, dict, "flowEnergy")
{
    read(dict);
    ledger_ = energyLedger::New(region());
    ledger_->begin(propertyDict());

    wordList columns
    ({
        "kinetic", "compression", "viscous", "eddy", "stabilisation", "weight", "transport", "boundary", "scheme"
    });
    columns.append(ledger_->patchNames());
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
    return true;
}


bool Foam::functionObjects::feFlowEnergy::execute()
{
    ledger_->enter();
    ledger_->keep(propertyDict());
    setResult("kinetic", ledger_->stored(energyLedger::KINETIC));
    setResult("compression", ledger_->stored(energyLedger::COMPRESSION));
    setResult("scheme", ledger_->scheme());
    return true;
}


bool Foam::functionObjects::feFlowEnergy::write()
{
    const energyLedger& e = ledger_();
    scalarList row({e.stored(energyLedger::KINETIC), e.stored(energyLedger::COMPRESSION)});
    Log << type() << " " << name() << " write:" << nl
        << "    kinetic " << row[0] << " J, compression " << row[1]
        << " J, taken by the time scheme " << e.scheme() << " J" << nl << endl;
    for
    (
        const label work :
        {
            energyLedger::VISCOUS, energyLedger::EDDY, energyLedger::STABILISATION,
            energyLedger::WEIGHT, energyLedger::TRANSPORT
        }
    )
    {
        row.append(e.work(work));
    }
    row.append(e.boundary());
    row.append(e.scheme());
    row.append(e.patchWorks());
    writeRow(file(), row);
    return true;
}


// ************************************************************************* //
