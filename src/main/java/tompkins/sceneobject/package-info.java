/**
 * What stands in the scene. A {@link tompkins.sceneobject.SceneObject} is the description that a scene file holds; it
 * adds {@link tompkins.primitive.Primitive primitives} to a {@link tompkins.sceneobject.PrimitiveCollector}, which are
 * what rays meet.
 */
package tompkins.sceneobject;
