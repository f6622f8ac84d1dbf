/** The search for the nearest primitive, and for what throws a shadow: tree, ray packets and light buffers. */
package tompkins.search;
