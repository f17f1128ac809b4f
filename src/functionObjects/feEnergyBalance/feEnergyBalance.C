/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "feEnergyBalance.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(feEnergyBalance, 0);
    addToRunTimeSelectionTable(functionObject, feEnergyBalance, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::interfaceReport* Foam::functionObjects::feEnergyBalance::interfaces() const
{
    const auto* report = time().cfindObject<interfaceReport>(interfaceReport::typeName);
    return report && report->nInterfaces() ? report : nullptr;
}


void Foam::functionObjects::feEnergyBalance::begin()
{
    wordList patches;
    for (const word& region : time().sortedNames<fvMesh>())
    {
        const auto* r = time().lookupObject<fvMesh>(region).cfindObject<feRegion>("feRegion");
        autoPtr<energyLedger> ledger(r ? energyLedger::New(*r) : nullptr);
        if (!ledger.valid()) continue;
        ledger->begin(propertyDict().subOrEmptyDict(region));
        for (const word& patch : ledger->patchNames()) patches.append(region + '.' + patch);
        ledgers_.append(ledger.ptr());
    }
    if (ledgers_.empty())
    {
        FatalErrorInFunction
            << "Function object " << name() << " of type " << typeName
            << ": no region has a solver of monolithicFoam" << exit(FatalError);
    }

    if (const interfaceReport* report = interfaces())
    {
        for (label i = 0; i < report->nInterfaces(); ++i)
        {
            patches.append(report->interfaceName(i) + ".fluid");
            patches.append(report->interfaceName(i) + ".solid");
        }
        interfaceWorks_.begin(propertyDict().subOrEmptyDict("interfaces"), 2*report->nInterfaces());
    }

    if (!writeToFile()) return;
    resetFile("energyBalance");
    wordList columns
    ({
        "kinetic", "strain", "compression", "potential", "weight", "viscous", "material", "eddy",
        "stabilisation", "transport", "boundary", "scheme"
    });
    columns.append(patches);
    writeHeader(file(), "Energies of all regions and what has changed them, J (in 2-D per metre of depth)");
    writeColumns(file(), columns);
}


void Foam::functionObjects::feEnergyBalance::enterInterfaces()
{
    const interfaceReport* report = interfaces();
    if (!report) return;
    scalarField now;
    for (label i = 0; i < report->nInterfaces(); ++i)
    {
        now.append(report->fluidPower(i));
        now.append(report->solidPower(i));
    }
    interfaceWorks_.add(ledgers_[0].region().timeScheme(), now);
    dictionary kept;
    interfaceWorks_.keep(kept);
    propertyDict().set("interfaces", kept);
}


template<class F>
Foam::scalar Foam::functionObjects::feEnergyBalance::total(const F& f) const
{
    scalar sum = 0;
    for (const energyLedger& ledger : ledgers_) sum += f(ledger);
    return sum;
}


void Foam::functionObjects::feEnergyBalance::judge(const scalar scheme)
{
    const scalar turnover = total([](const energyLedger& e)
    {
        scalar size = sum(mag(e.patchWorks()));
        for (label i = 0; i < energyLedger::PATCHES; ++i) size += mag(e.work(i));
        for (label i = 0; i < energyLedger::nStored; ++i) size += mag(e.stored(i));
        return size;
    });
    setResult("scheme", scheme);
    setResult("turnover", turnover);
    if (warned_ || mag(scheme) <= tolerance_*turnover) return;
    warned_ = true;
    WarningInFunction
        << "The energy balance does not close by " << scheme << " J of " << turnover
        << " J turned over, at time " << time().timeName() << ". The time scheme takes this;"
        << " halve the time step, which should leave a quarter of it." << endl;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::feEnergyBalance::feEnergyBalance
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    stateFunctionObject(name, runTime),
    tableFile(runTime, name, dict),
    warned_(false)
{
    read(dict);
    begin();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::feEnergyBalance::read(const dictionary& dict)
{
    reportUnknownEntries(dict, {"tolerance"});
    tolerance_ = dict.lookupOrDefault<scalar>("tolerance", 1);
    if (!(tolerance_ > 0))
    {
        FatalIOErrorInFunction(dict)
            << "tolerance " << tolerance_ << " is not positive" << exit(FatalIOError);
    }
    return stateFunctionObject::read(dict) && tableFile::read(dict);
}


bool Foam::functionObjects::feEnergyBalance::execute()
{
    for (energyLedger& ledger : ledgers_)
    {
        ledger.enter();
        dictionary kept;
        ledger.keep(kept);
        propertyDict().set(ledger.region().name(), kept);
    }
    enterInterfaces();

    row_.clear();
    for (label i = 0; i < energyLedger::nStored; ++i)
    {
        row_.append(total([i](const energyLedger& e) { return e.stored(i); }));
    }
    for (label i = 0; i < energyLedger::PATCHES; ++i)
    {
        row_.append(total([i](const energyLedger& e) { return e.work(i); }));
    }
    row_.append(total([](const energyLedger& e) { return e.boundary(); }));
    const scalar scheme = total([](const energyLedger& e) { return e.scheme(); });
    row_.append(scheme);
    for (const energyLedger& ledger : ledgers_) row_.append(ledger.patchWorks());
    row_.append(interfaceWorks_.works());
    judge(scheme);
    return true;
}


bool Foam::functionObjects::feEnergyBalance::write()
{
    if (row_.empty()) return true;
    Log << type() << " " << name() << " write:" << nl
        << "    kinetic " << row_[0] << " J, strain " << row_[1] << " J, compression " << row_[2]
        << " J; boundary " << row_[10] << " J, not closed by " << row_[11] << " J" << nl << endl;
    if (writeToFile()) writeRow(file(), row_);
    return true;
}


// ************************************************************************* //
