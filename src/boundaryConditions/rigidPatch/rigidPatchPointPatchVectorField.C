/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rigidPatchPointPatchVectorField.H"
#include "addToRunTimeSelectionTable.H"
#include "subDictOrEmpty.H"
#include "readNumber.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineNamedTemplateTypeNameAndDebug(rigidPatchPointPatchVectorField, 0);
    addToPointPatchFieldRunTimeSelection
    (
        pointPatchVectorField,
        rigidPatchPointPatchVectorField
    );
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static const wordList ownEntries({"translation", "rotation", "centre", "mass", "inertia"});
static const wordList axes({"x", "y", "z"});

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::rigidPatchCondition::readDirection
(
    const dictionary& dict,
    const word& axis,
    const word& load,
    const label direction
)
{
    const dictionary& d = dict.subDict(axis);
    reportUnknownEntries(d, {load, load + "Coeffs", "motion", "motionCoeffs"});
    free_[direction] = d.found(load);
    if (d.found(load) == d.found("motion"))
    {
        FatalIOErrorInFunction(d)
            << "Found " << (d.found(load) ? "both " : "neither ") << load
            << (d.found(load) ? " and " : " nor ") << "motion of direction " << axis
            << ", expected one of them" << exit(FatalIOError);
    }
    values_.set
    (
        direction, new optionalFunction1<scalar>(d.found(load) ? load : word("motion"), d)
    );
}


void Foam::rigidPatchCondition::readDirections
(
    const word& kind,
    const word& load,
    const label first
)
{
    const dictionary dict(subDictOrEmpty(dict_, kind));
    for (const entry& e : dict)
    {
        if (axes.found(e.keyword()) && e.isDict()) continue;
        FatalIOErrorInFunction(dict_)
            << "Found entry '" << e.keyword() << "' in " << kind << ", expected directions "
            << axes << ", as x { motion 0; } or x { " << load << " 1; }" << exit(FatalIOError);
    }
    forAll(axes, a)
    {
        if (dict.found(axes[a])) readDirection(dict, axes[a], load, first + a);
        else values_.set(first + a, new optionalFunction1<scalar>(scalar(0)));
    }
}


void Foam::rigidPatchCondition::checkInertia() const
{
    // The second moments of its mass are positive: so are all principal minors
    const symmTensor E(0.5*tr(inertia_)*symmTensor::I - inertia_);
    const scalar tolerance = -1e-6*mag(inertia_);
    const vector diagonal(E.xx(), E.yy(), E.zz());
    const vector minors
    (
        E.yy()*E.zz() - sqr(E.yz()), E.xx()*E.zz() - sqr(E.xz()), E.xx()*E.yy() - sqr(E.xy())
    );
    if
    (
        cmptMin(diagonal) >= tolerance && cmptMin(minors) >= -sqr(tolerance)
     && det(E) >= tolerance*sqr(tolerance) && mag(inertia_) < GREAT
    ) return;
    FatalIOErrorInFunction(dict_)
        << "Found inertia " << inertia_ << ", expected (xx xy xz yy yz zz) of a body: no"
        << " principal moment negative, nor larger than the sum of the other two"
        << exit(FatalIOError);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::rigidPatchCondition::rigidPatchCondition(const dictionary& dict, const Time&)
:
    dict_(dict.name()),
    free_(false),
    values_(nDirections),
    mass_(dict.found("mass") ? readNotNegative(dict, "mass", dimMass) : 0),
    inertia_(dict.lookupOrDefault<symmTensor>("inertia", Zero))
{
    for (const word& name : ownEntries)
    {
        if (const entry* e = dict.findEntry(name, keyType::LITERAL)) dict_.add(*e);
    }
    readDirections("translation", "force", TRANSLATION);
    readDirections("rotation", "moment", ROTATION);
    if (dict.found("centre")) centre_.reset(new point(dict.get<point>("centre")));
    checkInertia();
}


Foam::rigidPatchCondition::rigidPatchCondition(const rigidPatchCondition& c)
:
    dict_(c.dict_),
    free_(c.free_),
    mass_(c.mass_),
    inertia_(c.inertia_)
{
    for (const optionalFunction1<scalar>& f : c.values_) values_.append(new optionalFunction1<scalar>(f));
    if (c.centre_.valid()) centre_.reset(new point(c.centre_()));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::rigidPatchCondition::entries()
{
    return patchFieldEntries(wordList(), ownEntries);
}


void Foam::rigidPatchCondition::write(Ostream& os) const
{
    for (const entry& e : dict_) os << e;
}


// ************************************************************************* //
