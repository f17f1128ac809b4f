/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "feTimeScheme.H"
#include "unknownEntries.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(feTimeScheme, 0);
    defineRunTimeSelectionTable(feTimeScheme, dictionary);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::feTimeScheme::feTimeScheme()
:
    alphaM_(1), alphaF_(1), gamma_(1), beta_(1), delta_(0.5), steady_(false), deltaT_(1), deltaT0_(1)
{}


Foam::autoPtr<Foam::feTimeScheme> Foam::feTimeScheme::New
(
    const dictionary& dict
)
{
    const word type(dict.get<word>("type"));
    auto cstrIter = dictionaryConstructorTablePtr_->cfind(type);
    if (!cstrIter.found())
    {
        FatalIOErrorInLookup
        (
            dict, "timeScheme", type, *dictionaryConstructorTablePtr_
        ) << exit(FatalIOError);
    }
    return cstrIter()(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::feTimeScheme::rateByValue() const
{
    return steady_ ? 0 : alphaM_/(alphaF_*gamma_*deltaT_);
}


Foam::scalar Foam::feTimeScheme::displacementByUnknown() const
{
    return steady_ ? 1 : alphaF_*beta_*deltaT_/gamma_;
}


Foam::scalar Foam::feTimeScheme::velocityByUnknown() const
{
    return steady_ ? 0 : alphaF_;
}


Foam::scalar Foam::feTimeScheme::accelerationByUnknown() const
{
    return steady_ ? 0 : alphaM_/(gamma_*deltaT_);
}


bool Foam::feTimeScheme::operator==(const feTimeScheme& s) const
{
    return
        alphaM_ == s.alphaM_ && alphaF_ == s.alphaF_ && gamma_ == s.gamma_
     && beta_ == s.beta_ && delta_ == s.delta_ && steady_ == s.steady_;
}


// * * * * * * * * * * * * * * * * * Schemes * * * * * * * * * * * * * * * * //

namespace Foam
{
namespace timeSchemes
{

//- Newmark-beta: timeScheme { type Newmark; gamma 0.5; beta 0.25; }
//  gamma > 1/2 damps numerically (section 5.1 of Zhang and Zhu); beta defaults
//  to (gamma + 1/2)^2/4
class Newmark : public feTimeScheme
{
public:

    TypeName("Newmark");

    explicit Newmark(const dictionary& dict)
    {
        reportUnknownEntries(dict, {"type", "gamma", "beta"});
        gamma_ = dict.lookupOrDefault<scalar>("gamma", 0.5);
        beta_ = dict.lookupOrDefault<scalar>("beta", 0.25*sqr(gamma_ + 0.5));
        if (gamma_ < 0.5 || beta_ < 0.5*gamma_ - SMALL)
        {
            FatalIOErrorInFunction(dict)
                << "Newmark with gamma " << gamma_ << " and beta " << beta_
                << " is not unconditionally stable; expected gamma >= 1/2 and"
                << " beta >= gamma/2" << exit(FatalIOError);
        }
    }
};


//- Generalised-alpha: timeScheme { type generalisedAlpha; rhoInf 0.8; }
//  rhoInf in [0,1]: what is left of the highest frequency after a step
class generalisedAlpha : public feTimeScheme
{
public:

    TypeName("generalisedAlpha");

    explicit generalisedAlpha(const dictionary& dict)
    {
        reportUnknownEntries(dict, {"type", "rhoInf"});
        const scalar rho = dict.get<scalar>("rhoInf");
        if (rho < 0 || rho > 1)
        {
            FatalIOErrorInFunction(dict)
                << "rhoInf is " << rho << ", expected a number in [0,1]"
                << exit(FatalIOError);
        }
        alphaM_ = 0.5*(3 - rho)/(1 + rho);
        alphaF_ = 1/(1 + rho);
        gamma_ = 0.5 + alphaM_ - alphaF_;
        beta_ = 0.25*sqr(1 + alphaM_ - alphaF_);
    }
};


//- Backward Euler: timeScheme { type Euler; }
//  Of first order, damps all that the step does not resolve.  For a flow also
//  Newmark with gamma 1; for a solid no beta of Newmark's gives it
class Euler : public feTimeScheme
{
public:

    TypeName("Euler");

    explicit Euler(const dictionary&) { delta_ = 1; }
};


//- Steady: timeScheme { type steady; }; a step of time is a load step
class steady : public feTimeScheme
{
public:

    TypeName("steady");

    explicit steady(const dictionary& dict)
    {
        reportUnknownEntries(dict, {"type"});
        steady_ = true;
    }
};


defineTypeNameAndDebug(Newmark, 0);
defineTypeNameAndDebug(generalisedAlpha, 0);
defineTypeNameAndDebug(Euler, 0);
defineTypeNameAndDebug(steady, 0);
addToRunTimeSelectionTable(feTimeScheme, Newmark, dictionary);
addToRunTimeSelectionTable(feTimeScheme, generalisedAlpha, dictionary);
addToRunTimeSelectionTable(feTimeScheme, Euler, dictionary);
addToRunTimeSelectionTable(feTimeScheme, steady, dictionary);

} // End namespace timeSchemes
} // End namespace Foam


// ************************************************************************* //
