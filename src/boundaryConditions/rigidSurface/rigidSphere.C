/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Class
    Foam::rigidSphere

Description
    g = |x - c| - R, of a solid inside R - |x - c|
\*---------------------------------------------------------------------------*/

#include "rigidSurface.H"
#include "unknownEntries.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{

class rigidSphere
:
    public rigidSurface
{
    point centre_;
    scalar radius_, side_;

public:

    TypeName("sphere");

    explicit rigidSphere(const dictionary& dict)
    :
        centre_(dict.get<point>("centre")),
        radius_(readRadius(dict)),
        side_(readSide(dict))
    {
        reportUnknownEntries(dict, {"type", "centre", "radius", "side"});
    }

    virtual autoPtr<rigidSurface> clone() const { return autoPtr<rigidSurface>(new rigidSphere(*this)); }

    virtual distance at(const point& x) const
    {
        return round(x - centre_, symmTensor(symmTensor::I), radius_, side_);
    }

    virtual bool isAlong(const vector&) const { return false; }
};

defineTypeNameAndDebug(rigidSphere, 0);
addToRunTimeSelectionTable(rigidSurface, rigidSphere, dictionary);

} // End namespace Foam


// ************************************************************************* //
