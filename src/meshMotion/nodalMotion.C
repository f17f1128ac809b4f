/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "nodalMotion.H"
#include "fixedValuePointPatchFields.H"
#include "nodalSurface.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static bool readIncremental(const dictionary& dict)
{
    static const Enum<label> configurations({{0, "total"}, {1, "incremental"}});
    return configurations.getOrDefault("configuration", dict, 0) == 1;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::nodalMotion::makeBoundary(pointVectorField*& boundary)
{
    if (!boundary)
    {
        const polyBoundaryMesh& patches = fe_.mesh().boundaryMesh();
        wordList types(patches.size(), "fixedValue");
        forAll(patches, p)
        {
            if (polyPatch::constraintType(patches[p].type())) types[p] = patches[p].type();
        }
        byDefault_.reset
        (
            new pointVectorField
            (
                IOobject("meshDisplacement", fe_.mesh().time().timeName(), fe_.mesh()),
                pointMesh::New(fe_.mesh()),
                dimensionedVector(dimLength, Zero),
                types
            )
        );
        boundary = byDefault_.get();
    }
    boundary_.reset(new nodalBoundary(fe_, *boundary));
    field_ = boundary;
    for (const auto& pf : boundary->boundaryField())
    {
        curved_ = curved_ || dynamic_cast<const nodalSurface*>(&pf);
    }
}


Foam::motionWalls Foam::nodalMotion::walls(const pointVectorField& boundary) const
{
    labelHashSet moving, resting;
    forAll(boundary.boundaryField(), patchi)
    {
        const auto& pf = boundary.boundaryField()[patchi];
        if (!isA<valuePointPatchField<vector>>(pf)) continue;
        const bool rests =
            typeid(pf) == typeid(fixedValuePointPatchField<vector>)
         && gMax(mag(refCast<const valuePointPatchField<vector>>(pf))) < VSMALL;
        (rests ? resting : moving).insert(fe_.patchNodes(patchi));
    }
    for (const label patchi : heldPatches_) moving.insert(fe_.patchNodes(patchi));
    resting -= moving;
    return {moving.sortedToc(), resting.sortedToc(), solverDict_};
}


void Foam::nodalMotion::number(const fieldLayout::kind kind)
{
    layout_.reset
    (
        new fieldLayout
        (
            fe_,
            {{"meshDisplacement", kind, fieldLayout::support::NODES, dimLength}}
        )
    );
    map_.reset(new nodeMap(layout_->keys(), fieldUnknowns::counts(layout_())));
    unknowns_.reset(new fieldUnknowns(layout_(), map_()));
}


void Foam::nodalMotion::addProblem(const labelList& axes)
{
    problems_.append(new problem);
    problems_.last().axes = axes;
    problems_.last().constraints.reset(new dofConstraints(map_()));
}


void Foam::nodalMotion::makeMatrix(problem& p)
{
    p.factors.clear();
    p.K.reset(new feMatrix(map_(), map_(), p.constraints.get(), scatter_, true));
    p.factors.reset(new feFactors(map_(), p.K(), solverDict_));
}


bool Foam::nodalMotion::constrain(dofConstraints& constraints)
{
    constraints.reopen();
    boundary_->constrain(unknowns_(), 0, constraints);
    for (const label patchi : heldPatches_) for (const label n : fe_.patchNodes(patchi))
    {
        for (label a = 0; a < fe_.dim(); ++a) constraints.fix(unknowns_->start(0, n) + a);
    }
    return constraints.close();
}


Foam::List<Foam::labelList> Foam::nodalMotion::uncoupled(const dofConstraints& all) const
{
    if (returnReduce(all.slaves().size(), sumOp<label>())) return List<labelList>();

    DynamicList<labelList> groups;
    for (label a = 0; a < fe_.dim(); ++a)
    {
        const auto heldAs = [&](const labelList& group)
        {
            bool same = true;
            for (label n = 0; n < fe_.nNodes(); ++n)
            {
                const label u = unknowns_->start(0, n);
                same = same && all.isGiven(u + a) == all.isGiven(u + group[0]);
            }
            return returnReduce(same, andOp<bool>());
        };
        label g = 0;
        while (g < groups.size() && !heldAs(groups[g])) ++g;
        if (g == groups.size()) groups.append(labelList());
        groups[g].append(a);
    }
    return List<labelList>(std::move(groups));
}


void Foam::nodalMotion::initialise(const bool scalarsServe)
{
    number(fieldLayout::kind::VECTOR);
    addProblem(identity(fe_.dim()));
    constrain(problems_[0].constraints());
    const List<labelList> groups(scalarsServe && !curved_ ? uncoupled(problems_[0].constraints()) : List<labelList>());
    if (groups.size())
    {
        // What is held of the vector, by component
        List<boolList> held(fe_.dim(), boolList(fe_.nNodes()));
        forAll(held, a) forAll(held[a], n) held[a][n] = problems_[0].constraints->isGiven(unknowns_->start(0, n) + a);
        problems_.clear();
        number(fieldLayout::kind::SCALAR);
        for (const labelList& group : groups)
        {
            addProblem(group);
            dofConstraints& constraints = problems_.last().constraints();
            const boolList& here = held[group[0]];
            forAll(here, n) if (here[n]) constraints.fix(unknowns_->start(0, n));
            constraints.close();
        }
    }
    for (const elementBlock& block : fe_.blocks())
    {
        scatter_.append(new elementScatter(block, unknowns_()));
    }
    for (problem& p : problems_)
    {
        for (label& a : p.axes) a = fe_.axis(a);
        p.x.setSize(groups.size() ? p.axes.size() : 1, scalarField(map_->nUnknowns()));
        p.b = p.x;
        makeMatrix(p);
    }
    factorise(vectorField(fe_.nNodes(), Zero));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::nodalMotion::nodalMotion
(
    const feMesh& fe,
    pointVectorField* boundary,
    const labelUList& heldPatches,
    const dictionary& dict,
    const dictionary& solver,
    const wordList& ownEntries
)
:
    fe_(fe),
    heldPatches_(heldPatches),
    dict_(dict),
    solverDict_(solver),
    incremental_(readIncremental(dict)),
    updates_(dict.getOrDefault<bool>("update", false))
{
    makeBoundary(boundary);
    wordList entries({"configuration", "update"});
    entries.append(ownEntries);
    stiffness_ = meshStiffness::New(fe, walls(*boundary), dict, entries);
}


// ************************************************************************* //
