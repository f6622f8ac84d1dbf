package tompkins.sceneobject;

/** Something in the scene: a shape, or several of them. Descriptions, immutable, checked when they are made. */
public sealed interface SceneObject
        permits Sphere,
                Plane,
                Disc,
                Parallelogram,
                Triangle,
                TriangleMesh,
                Box,
                Cylinder,
                Cone,
                CylinderLattice,
                Silhouette,
                Group,
                Placed,
                ImagePointGrid,
                Hidden {

    /** What the user calls the object. */
    String description();

    /** Adds the primitives of this object, placed, in the order in which they are listed. */
    void addTo(PrimitiveCollector collector, Placement placement);
}
