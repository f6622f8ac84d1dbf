/**
 * What stands in the scene. A {@link tompkins.sceneobject.SceneObject} is the description that a scene file holds; it
 * adds {@link tompkins.sceneobject.Primitive primitives} to a {@link tompkins.sceneobject.PrimitiveCollector}, which
 * are what rays meet. {@link tompkins.sceneobject.ObjectTree} finds the nearest of them.
 */
package tompkins.sceneobject;
