/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "remeshMemory.H"
#include "elementQuality.H"
#include "points0MotionSolver.H"
#include "unknownEntries.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalarField Foam::cellSizes(const feMesh& fe)
{
    const scalar regular = fe.dim() == 2 ? Foam::sqrt(3.0)/4 : Foam::sqrt(2.0)/12;
    const elementQualities all(qualities(fe, fe.points()));
    scalarField sum(fe.nVertices(), 0), n(sum);
    forAll(all, b) forAll(all[b], e)
    {
        const elementBlock& block = fe.blocks()[b];
        for (label i = 0; i < block.nVertices(); ++i)
        {
            sum[block.element(e)[i]] += all[b][e].volume/regular;
            n[block.element(e)[i]] += 1;
        }
    }
    for (scalarField* f : {&sum, &n})
    {
        f->setSize(fe.nNodes(), 0);
        fe.copies().sum(*f);
    }
    scalarField size(sum/max(n, scalar(1)));
    size.setSize(fe.nVertices());
    for (scalar& s : size) s = Foam::pow(s, 1.0/fe.dim());
    return size;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Object>
bool Foam::remeshMemory::exact<Object>::writeObject
(
    IOstream::streamFormat format,
    IOstream::versionNumber version,
    IOstream::compressionType compression,
    const bool valid
) const
{
    const unsigned digits = IOstream::defaultPrecision(17);
    const bool ok = Object::writeObject(format, version, compression, valid);
    IOstream::defaultPrecision(digits);
    return ok;
}


Foam::IOobject Foam::remeshMemory::sizesIO(const IOobject::readOption read) const
{
    return IOobject("remeshSize", region_.mesh().time().timeName(), region_.mesh(), read, IOobject::AUTO_WRITE);
}


void Foam::remeshMemory::makeSizes(const dictionary& dict)
{
    scalarField size(cellSizes(region_.fe()));
    size *= dict.getOrDefault<scalar>("factor", 1);
    const scalar least = dict.getOrDefault<scalar>("min", 0), most = dict.getOrDefault<scalar>("max", GREAT);
    for (scalar& s : size) s = min(max(s, least), most);
    sizes_.reset
    (
        new exact<pointScalarField>
        (
            sizesIO(IOobject::NO_READ), pointMesh::New(region_.mesh()), dimensionedScalar(dimLength, Zero)
        )
    );
    setSizes(size);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::remeshMemory::remeshMemory(const feRegion& region, const dictionary& size)
:
    region_(region)
{
    reportUnknownEntries(size, {"factor", "min", "max"});
    const IOobject points0(points0MotionSolver::points0IO(region_.mesh()));
    const bool exchanged =
        points0.name() == "points0" && points0.instance() != region_.mesh().time().constant();
    if (exchanged) setPoints0(pointIOField(points0));

    IOobject io(sizesIO(IOobject::MUST_READ));
    if (returnReduce(io.typeHeaderOk<pointScalarField>(), andOp<bool>()))
    {
        sizes_.reset(new exact<pointScalarField>(io, pointMesh::New(region_.mesh())));
        return;
    }
    if (exchanged)
    {
        WarningInFunction
            << "The mesh of region " << region_.name() << " has been exchanged, but there is no "
            << io.objectPath() << ": its cells have the sizes that are wanted" << endl;
    }
    makeSizes(size);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalarField Foam::remeshMemory::sizes() const
{
    scalarField s(region_.fe().nVertices());
    forAll(s, n) s[n] = size(n);
    return s;
}


void Foam::remeshMemory::setSizes(const scalarField& size)
{
    region_.fe().toPoints<scalar>(size, sizes_->primitiveFieldRef());
}


void Foam::remeshMemory::setPoints0(const pointField& points0)
{
    points0_.clear();
    points0_.reset
    (
        new exact<pointIOField>
        (
            IOobject
            (
                "points0", region_.mesh().time().timeName(), polyMesh::meshSubDir, region_.mesh(),
                IOobject::NO_READ, IOobject::AUTO_WRITE
            ),
            points0
        )
    );
}


// ************************************************************************* //
