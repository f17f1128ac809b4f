/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidWatch.H"
#include "enhancedKernel.H"
#include "materialLaw.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::solidWatch::finding::add(const point& x, const vector& l)
{
    if (++nCells > 1) return;
    at = x;
    stretch = l;
}


void Foam::solidWatch::finding::combine()
{
    const label rank = returnReduce(nCells ? Pstream::myProcNo() : labelMax, minOp<label>());
    if (rank != Pstream::myProcNo()) at = stretch = vector::min;
    reduce(nCells, sumOp<label>());
    reduce(at, maxOp<vector>());
    reduce(stretch, maxOp<vector>());
}


void Foam::solidWatch::warnOfLaw(const label materiali, finding found)
{
    found.combine();
    if (!found.nCells) return;
    lawTold_[materiali] = true;
    WarningInFunction
        << "Material '" << assembly_.materialNames()[materiali] << "' of region " << fe_.mesh().name()
        << " is not stable at the principal stretches " << found.stretch << ", which it has at "
        << found.at << " at time " << fe_.mesh().time().timeName() << ", in " << found.nCells
        << " cells: a strain grows there while its stress falls (dtau : dh <= 0)." << nl
        << "The solution may not be unique. Choose another law, or parameters that are"
        << " fitted in this range (materialCurve)" << nl << endl;
}


void Foam::solidWatch::warnOfHourglass(finding found)
{
    found.combine();
    if (!found.nCells) return;
    hourglassTold_ = true;
    WarningInFunction
        << "Elements enhancedStrain of region " << fe_.mesh().name() << " have lost the stiffness of"
        << " their hourglass modes, under compression, in " << found.nCells << " cells, one at "
        << found.at << ", at time " << fe_.mesh().time().timeName() << '.' << nl
        << "Displacements may alternate from cell to cell there. Choose other elements, as"
        << " quadratic or Q1Q0" << nl << endl;
}


template<class E>
void Foam::solidWatch::findHourglass
(
    const label blocki,
    const vectorField& D,
    finding& found
) const
{
    const elementBlock& block = assembly_.blocks()[blocki];
    const FixedList<label, 3> axis({fe_.axis(0), fe_.axis(1), fe_.axis(2)});
    const materialLaw law(assembly_.material(blocki));
    enhancedKernel<pack, E, materialLaw> kernel(law);
    solidNodes<pack, E> n;
    block.forBatches([&](const label batch)
    {
        gather<E, E::dim>(block, batch, fe_.points(), axis, n.X);
        gather<E, E::dim>(block, batch, D, axis, n.D);
        const pack stiffness = kernel.hourglassStiffness(n);
        for (int l = 0; l < block.nLanes(batch); ++l)
        {
            const label cell = block.cells[block.lane(batch, l)];
            if (!(stiffness[l] > 0)) found.add(fe_.mesh().cellCentres()[cell], vector::one);
        }
    });
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::solidWatch::solidWatch(const feMesh& fe, const solidAssembly& assembly)
:
    fe_(fe),
    assembly_(assembly),
    lawTold_(assembly.materialNames().size(), false)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::solidWatch::stable
(
    const solidMaterial& law,
    const bool mixed,
    const vector& stretch
)
{
    typedef Ten<scalar, 3> ten;
    const auto* distortion = mixed ? &static_cast<const mixedMaterial&>(law) : nullptr;
    ten F = ten::zero();
    for (label i = 0; i < 3; ++i) F(i, i) = stretch[i];
    const ten P = distortion ? distortion->Piso(F) : law.P(F);

    // d tau_i/d h_j
    ten H = ten::zero();
    for (label j = 0; j < 3; ++j)
    {
        ten dF = ten::zero();
        dF(j, j) = stretch[j];
        const ten dP = distortion ? distortion->dPiso(F, dF) : law.dP(F, dF);
        for (label i = 0; i < 3; ++i) H(i, j) = stretch[i]*dP(i, i);
        H(j, j) += stretch[j]*P(j, j);
    }
    if (distortion)
    {
        // Among (1 -1 0)/sqrt(2), (1 1 -2)/sqrt(6); the third has the law's largest
        // stiffness, to be no part of it
        static const scalar r2 = 1/::sqrt(2.0), r3 = 1/::sqrt(3.0), r6 = 1/::sqrt(6.0);
        ten Q;
        const scalar rows[3][3] = {{r2, -r2, 0}, {r6, r6, -2*r6}, {r3, r3, r3}};
        for (label i = 0; i < 3; ++i) for (label j = 0; j < 3; ++j) Q(i, j) = rows[i][j];
        H = Q & H & Q.t();
        const scalar s = mag(H(0, 0)) + mag(H(1, 1));
        for (label i = 0; i < 2; ++i) H(i, 2) = H(2, i) = 0;
        H(2, 2) = s;
    }
    const solidLaws::symmetricEigen<scalar, 3> eigen(0.5*(H + H.t()));
    return min(eigen.c[0], min(eigen.c[1], eigen.c[2])) > 0;
}


void Foam::solidWatch::check(const solidPoints& points, const vectorField& D)
{
    List<finding> laws(lawTold_.size());
    boolList isSqueezed(assembly_.blocks().size(), false);
    points.atCentres([&](const label b, const label e, const solidPoint& s)
    {
        const vector stretch(s.principalStretch());
        if (cmptMax(cmptMag(stretch - vector::one)) < smallStrain) return;
        isSqueezed[b] = isSqueezed[b] || stretch.z() < 1 - smallStrain;
        const label m = assembly_.materialOf(b);
        if (lawTold_[m] || !assembly_.material(b).ofStretches()) return;
        if (stable(assembly_.material(b), assembly_.mixed(b), stretch)) return;
        laws[m].add(fe_.mesh().cellCentres()[assembly_.blocks()[b].cells[e]], stretch);
    });
    forAll(laws, m) if (!lawTold_[m]) warnOfLaw(m, laws[m]);
    if (hourglassTold_) return;

    finding hourglass;
    forAll(isSqueezed, b)
    {
        if (!isSqueezed[b] || !assembly_.enhanced(b)) continue;
        if (assembly_.blocks()[b].shape == elementShape::HEX) findHourglass<Hex1>(b, D, hourglass);
        else findHourglass<Quad1>(b, D, hourglass);
    }
    warnOfHourglass(hourglass);
}


// ************************************************************************* //
