/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "flowStabilisation.H"
#include "subDictOrEmpty.H"
#include "unknownEntries.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(flowStabilisation, 0);
    defineRunTimeSelectionTable(flowStabilisation, dictionary);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::flowStabilisation::flowStabilisation
(
    const dictionary& schemes,
    const word& type,
    const flowFamily family,
    const scalar factor
)
{
    const dictionary coeffs(subDictOrEmpty(schemes, type + "Coeffs"));
    const auto read = [&](const word& name, const scalar value)
    {
        const scalar x = coeffs.lookupOrDefault<scalar>(name, value);
        if (!(x >= 0 && x < GREAT))
        {
            FatalIOErrorInFunction(coeffs)
                << name << " is " << x << ", expected a number >= 0" << exit(FatalIOError);
        }
        return x;
    };
    reportUnknownEntries(coeffs, {"supg", "pspg", "lsic"});
    supg_ = read("supg", factor);
    pspg_ = read("pspg", family == flowFamily::EQUAL_ORDER ? factor : 0);
    lsic_ = read("lsic", family == flowFamily::Q1Q0 ? 0 : factor);
    if (family != flowFamily::EQUAL_ORDER && pspg_ > 0)
    {
        FatalIOErrorInFunction(coeffs)
            << "pspg is " << pspg_ << ", expected 0: only elements equalOrder have it"
            << exit(FatalIOError);
    }
}


Foam::autoPtr<Foam::flowStabilisation> Foam::flowStabilisation::New
(
    const dictionary& schemes,
    const flowFamily family
)
{
    const bool equalOrder = family == flowFamily::EQUAL_ORDER;
    const word type
    (
        schemes.lookupOrDefault<word>("stabilisation", equalOrder ? "metric" : "none")
    );
    auto cstrIter = dictionaryConstructorTablePtr_->cfind(type);
    if (!cstrIter.found())
    {
        FatalIOErrorInLookup
        (
            schemes, "stabilisation", type, *dictionaryConstructorTablePtr_
        ) << exit(FatalIOError);
    }
    if (equalOrder && type == "none")
    {
        FatalIOErrorInFunction(schemes)
            << "Elements equalOrder with stabilisation none have a singular"
            << " pressure. Choose stabilisation metric, or elements taylorHood"
            << exit(FatalIOError);
    }
    return cstrIter()(schemes, family);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::flowStabilisation::entries(const dictionary& schemes)
{
    wordList all({"stabilisation"});
    all.append(word(schemes.lookupOrDefault<word>("stabilisation", "metric") + "Coeffs"));
    return all;
}


void Foam::flowStabilisation::set(flowParameters& k) const
{
    k.stabilised = supg_ + pspg_ + lsic_ > 0;
    k.supg = supg_;
    k.pspg = pspg_;
    k.lsic = lsic_;
}


// * * * * * * * * * * * * * * * * * Models  * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace stabilisations
{

//- Galerkin's method
class none : public flowStabilisation
{
public:

    TypeName("none");

    none(const dictionary& schemes, const flowFamily family)
    :
        flowStabilisation(schemes, typeName, family, 0)
    {}
};


//- tauS of the metric tensor, with 2/dt
class metric : public flowStabilisation
{
public:

    TypeName("metric");

    metric(const dictionary& schemes, const flowFamily family)
    :
        flowStabilisation(schemes, typeName, family, 1)
    {}
};


//- tauS of lengths along the flow, with 2/dt
class elementLength : public flowStabilisation
{
public:

    TypeName("elementLength");

    elementLength(const dictionary& schemes, const flowFamily family)
    :
        flowStabilisation(schemes, typeName, family, 1)
    {}

    virtual void set(flowParameters& k) const
    {
        flowStabilisation::set(k);
        k.lengths = true;
    }
};


//- tauS of the metric tensor without time, subscales tracked
class tracked : public flowStabilisation
{
public:

    TypeName("tracked");

    tracked(const dictionary& schemes, const flowFamily family)
    :
        flowStabilisation(schemes, typeName, family, 1)
    {}

    virtual void set(flowParameters& k) const
    {
        flowStabilisation::set(k);
        k.transient = false;
        k.tracked = true;
    }
};


defineTypeNameAndDebug(none, 0);
defineTypeNameAndDebug(metric, 0);
defineTypeNameAndDebug(elementLength, 0);
defineTypeNameAndDebug(tracked, 0);
addToRunTimeSelectionTable(flowStabilisation, none, dictionary);
addToRunTimeSelectionTable(flowStabilisation, metric, dictionary);
addToRunTimeSelectionTable(flowStabilisation, elementLength, dictionary);
addToRunTimeSelectionTable(flowStabilisation, tracked, dictionary);

} // End namespace stabilisations
} // End namespace Foam


// ************************************************************************* //
